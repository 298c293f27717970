package rasterlab.tests.frontdoor;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import rasterlab.tests.Repository;

/** The README, the pages on exercises and on models, each in two languages, and CONTRIBUTING.md. */
final class Readme {
    /** The pages that users read, in English; each has a Russian one beside it. */
    static final List<String> PAGES =
            List.of("README.md", "exercises/README.md", "engine/models.md");

    private static final Pattern BLOCK = Pattern.compile("(?m)^```sh\\R(.*?)^```", Pattern.DOTALL);
    private static final Pattern ANY_BLOCK =
            Pattern.compile("(?m)^```.*?^```$", Pattern.DOTALL | Pattern.MULTILINE);
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");

    private Readme() {}

    static String russian(String page) {
        return page.replaceFirst("\\.md$", ".ru.md");
    }

    static String text(String name) {
        return Repository.text(Repository.root().resolve(name));
    }

    /** The commands of all pages. */
    static List<String> commands() {
        return PAGES.stream().flatMap(page -> commands(text(page)).stream()).toList();
    }

    /** The lines of a text's blocks for a shell, without what they say after a #. */
    static List<String> commands(String text) {
        var commands = new ArrayList<String>();
        var blocks = BLOCK.matcher(text);
        while (blocks.find())
            for (var line : blocks.group(1).split("\\R"))
                if (!line.isBlank()) commands.add(line.replaceFirst("\\s+#.*", "").strip());
        return commands;
    }

    /** The words between backquotes in a text outside its blocks, spaces and lines alike. */
    static Set<String> codes(String text) {
        var codes = new TreeSet<String>();
        var found = CODE.matcher(ANY_BLOCK.matcher(text).replaceAll(""));
        while (found.find()) codes.add(found.group(1).replaceAll("\\s+", " "));
        return codes;
    }

    /** How many lines of a text match a pattern. */
    static long count(String text, String line) {
        return text.lines().filter(each -> each.matches(line)).count();
    }
}
