package rasterlab.tests.rules;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.tests.Repository;

/** The English help that stands with commands, options and parameters in the sources. */
final class HelpTexts {
    private static final Pattern ANNOTATION =
            Pattern.compile("@(?:[\\w.]+\\.)?(?:Command|Option|Parameters|ArgGroup)\\(");

    /**
     * One literal, or several that are added up; brackets and quotes alone stand outside of one.
     */
    private static final Pattern PART =
            Pattern.compile("\"((?:[^\"\\\\]|\\\\.)*)\"|[()]", Pattern.DOTALL);

    private static final Pattern ADDED = Pattern.compile("\"\\s*\\+\\s*\"");

    private HelpTexts() {}

    /**
     * A text of a command's help.
     *
     * @param line where its annotation begins, counted from 1
     * @param words the text, with its escapes as in the source
     */
    record HelpText(int line, String words) {}

    /** The sources that use picocli. */
    static List<Path> files() throws IOException {
        var files = new ArrayList<Path>();
        for (String module : Repository.MODULES) {
            Path main = Repository.root().resolve(module).resolve("src/main");
            if (!Files.exists(main)) continue;
            List<Path> sources;
            try (var all = Files.walk(main)) {
                sources = all.filter(file -> file.toString().matches(".*\\.(java|kt)")).toList();
            }
            for (Path source : sources)
                if (Files.readString(source).contains("import picocli")) files.add(source);
        }
        return files;
    }

    static List<HelpText> in(String source) {
        var texts = new ArrayList<HelpText>();
        for (Matcher found = ANNOTATION.matcher(source); found.find(); ) {
            int line = (int) source.substring(0, found.start()).lines().count() + 1;
            for (String words : literals(source, found.end())) texts.add(new HelpText(line, words));
        }
        return texts;
    }

    /** The literals from there on, as far as the bracket that closes the annotation. */
    private static List<String> literals(String source, int from) {
        var literals = new ArrayList<String>();
        Matcher part = PART.matcher(source);
        int open = 1;
        int end = -1;
        for (int at = from; open > 0 && part.find(at); at = part.end()) {
            if (part.group(1) == null) open += part.group().equals("(") ? 1 : -1;
            else if (end >= 0 && ADDED.matcher(source).region(end - 1, part.start() + 1).matches())
                literals.add(literals.remove(literals.size() - 1) + part.group(1));
            else literals.add(part.group(1));
            if (part.group(1) != null) end = part.end();
        }
        return literals;
    }
}
