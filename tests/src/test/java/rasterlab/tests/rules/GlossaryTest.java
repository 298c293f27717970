package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.tests.Repository;

/** Holds what people read to one name for one thing, the one of the glossary. */
class GlossaryTest {
    /** The English help of all commands with its places, once it was read. */
    private static final Map<String, List<String>> HELP = new LinkedHashMap<>();

    static Stream<Glossary.Banned> banned() {
        return Glossary.read().banned().stream();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("banned")
    void noTextHasIt(Glossary.Banned banned) throws IOException {
        assertTrue(
                banned.phrase().in(banned.phrase().caught()),
                () ->
                        "glossary.json: \"wrong\" does not find its \"caught\", "
                                + banned.phrase().caught());
        var found = new ArrayList<String>();
        for (Path file : texts()) {
            if (!speaks(file, banned.language())) continue;
            List<String> lines = Files.readAllLines(file);
            for (int i = 0; i < lines.size(); i++)
                if (banned.phrase().in(value(lines.get(i))))
                    found.add(Repository.root().relativize(file) + ":" + (i + 1));
        }
        if (!banned.language().equals("ru")) found.addAll(helpWith(banned.phrase()));
        assertEquals(
                List.of(),
                found,
                "in place of " + banned.phrase().caught() + " write there " + banned.right());
    }

    /** The places in the English help of commands where that phrase stands. */
    private static List<String> helpWith(Glossary.Phrase phrase) throws IOException {
        if (HELP.isEmpty())
            for (Path file : HelpTexts.files())
                for (HelpTexts.HelpText text : HelpTexts.in(Files.readString(file)))
                    HELP.computeIfAbsent("=" + text.words(), words -> new ArrayList<>())
                            .add(Repository.root().relativize(file) + ":" + text.line());
        return HELP.entrySet().stream()
                .filter(one -> phrase.in(one.getKey()))
                .flatMap(one -> one.getValue().stream())
                .toList();
    }

    @Test
    @DisplayName("help of a command that is written over several lines is not read")
    void readsTheHelpOfCommands() throws IOException {
        assertEquals(
                List.of(new HelpTexts.HelpText(2, "--a"), new HelpTexts.HelpText(2, "one (1) two")),
                HelpTexts.in(
                        "x\n@Option(names = \"--a\", description = \"one (1)\"\n + \" two\") String a"));
        for (String name : List.of("BenchCommand.java", "LookOptions.java", "ServeCommand.kt"))
            assertTrue(
                    HelpTexts.files().stream().anyMatch(file -> file.endsWith(name)),
                    () -> "no help is read of " + name);
    }

    @Test
    void eachThingHasOneNameInEachLanguage() {
        var names = new HashSet<String>();
        var twice = new ArrayList<String>();
        for (Glossary.Term term : Glossary.read().terms())
            for (String name : List.of("en " + term.en(), "ru " + term.ru()))
                if (!names.add(name)) twice.add(name);
        assertEquals(
                List.of(),
                twice,
                "glossary.json has two terms of one name: rename one or take it out");
    }

    @Test
    void everyTermStandsInTextsOfItsLanguage() throws IOException {
        var unused = new ArrayList<String>();
        String english = all("en");
        String russian = all("ru");
        for (Glossary.Term term : Glossary.read().terms()) {
            if (!term.english().matcher(english).find()) unused.add(term.en());
            if (!term.russian().matcher(russian).find()) unused.add(term.ru());
        }
        assertEquals(
                List.of(),
                unused,
                "glossary.json has terms that no text uses: take them out or use them");
    }

    @Test
    void bundlesOfBothLanguagesAndStatementsAreRead() throws IOException {
        List<String> names = texts().stream().map(file -> file.getFileName().toString()).toList();
        for (String name : List.of("messages.properties", "messages_ru.properties", "cases.json"))
            assertTrue(names.contains(name), () -> "no file is read that is called " + name);
        for (String name : List.of("statement.en.md", "statement.ru.md", "command_ru.properties"))
            assertTrue(names.contains(name), () -> "no file is read that is called " + name);
    }

    /** The part of a bundle's line from its "=" on; another line as it is. */
    private static String value(String line) {
        int equals = line.indexOf('=');
        return line.startsWith("#") ? "" : equals < 0 ? line : line.substring(equals);
    }

    private static String all(String language) throws IOException {
        var all = new StringBuilder();
        for (Path file : texts())
            if (speaks(file, language))
                for (String line : Files.readAllLines(file)) all.append(value(line)).append('\n');
        return all.toString();
    }

    /** Whether texts of that language stand in a file; JSON has both. */
    private static boolean speaks(Path file, String language) {
        String name = file.getFileName().toString();
        boolean russian = name.contains("_ru.") || name.contains(".ru.");
        return language.isEmpty() || name.endsWith(".json") || russian == language.equals("ru");
    }

    /** The files whose words people read; measured results are numbers. */
    private static List<Path> texts() throws IOException {
        var texts = new ArrayList<Path>();
        for (String name :
                List.of(
                        "README.md",
                        "README.ru.md",
                        "exercises/README.md",
                        "exercises/README.ru.md",
                        "engine/models.md",
                        "engine/models.ru.md")) texts.add(Repository.root().resolve(name));
        for (String module : Repository.MODULES) {
            Path resources = Repository.root().resolve(module).resolve("src/main/resources");
            if (!Files.exists(resources)) continue;
            try (var files = Files.walk(resources)) {
                files.filter(file -> file.toString().matches(".*\\.(properties|md|json)"))
                        .filter(file -> !file.getParent().endsWith("study/shipped"))
                        .forEach(texts::add);
            }
        }
        return texts;
    }
}
