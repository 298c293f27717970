package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class BundlesTest {
    private static final List<Path> ROOTS =
            List.of(
                    Path.of("src/main/resources/rasterlab/app"),
                    Translations.FOLDER,
                    Translations.FOLDER.resolveSibling("complaint"));

    /** The names on keys, the same in both languages. */
    private static final String KEYS = "\\b(Delete|Enter|Home|Shift|Space)\\b";

    /** Keys of what the engine says in English: {@link TopicTextsTest} looks at the Russian. */
    private static final Pattern OF_THE_ENGINE =
            Pattern.compile("(?!field\\.).*\\.decision|matrix\\.[A-Z].*|reads|answers|word\\..*");

    /** Every English file that must say the same as its Russian one. */
    static List<Path> englishFiles() throws IOException {
        return allFiles().stream()
                .filter(file -> !file.toString().endsWith("_ru.properties"))
                .toList();
    }

    @ParameterizedTest(name = "a text is missing in one language: {0}")
    @MethodSource("englishFiles")
    void hasTheSameKeysInBothLanguages(Path english) throws IOException {
        var russian = new TreeSet<>(read(russian(english)).stringPropertyNames());
        if (english.startsWith(Translations.FOLDER))
            russian.removeIf(key -> OF_THE_ENGINE.matcher(key).matches());
        assertEquals(new TreeSet<>(read(english).stringPropertyNames()), russian);
    }

    @ParameterizedTest(name = "a later text hides an earlier one of the same key: {0}")
    @MethodSource("allFiles")
    void hasEachKeyOnce(Path file) throws IOException {
        var twice = new TreeSet<Object>();
        var read =
                new Properties() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    public synchronized Object put(Object key, Object text) {
                        Object earlier = super.put(key, text);
                        if (earlier != null) twice.add(key);
                        return earlier;
                    }
                };
        try (var text = Files.newBufferedReader(file)) {
            read.load(text);
        }
        assertEquals(new TreeSet<>(), twice);
    }

    static List<Path> allFiles() throws IOException {
        var all = new ArrayList<Path>();
        for (Path root : ROOTS)
            try (Stream<Path> files = Files.walk(root)) {
                files.filter(file -> file.toString().endsWith(".properties"))
                        .sorted()
                        .forEach(all::add);
            }
        return all;
    }

    @ParameterizedTest(name = "a translation drops or invents a placeholder: {0}")
    @MethodSource("englishFiles")
    void hasTheSamePlaceholdersInBothLanguages(Path english) throws IOException {
        Properties translated = read(russian(english));
        read(english)
                .forEach(
                        (key, text) ->
                                assertEquals(
                                        Placeholders.of((String) text),
                                        Placeholders.of(translated.getProperty((String) key)),
                                        "key " + key));
    }

    @ParameterizedTest(name = "a plural lacks a form of its language: {0}")
    @MethodSource("allFiles")
    void pluralsHaveTheFormsOfTheirLanguage(Path file) throws IOException {
        boolean russian = file.toString().endsWith("_ru.properties");
        List<String> forms = russian ? List.of("one", "few", "many") : List.of("one", "other");
        Properties texts = read(file);
        for (String key : texts.stringPropertyNames()) {
            String[] plurals = texts.getProperty(key).split("\\{\\d,plural,", -1);
            for (int i = 1; i < plurals.length; i++)
                for (String form : forms)
                    assertTrue(
                            Pattern.compile("(^|\\|)" + form + "#").matcher(plurals[i]).find(),
                            key + ": " + form);
        }
    }

    @ParameterizedTest(name = "a text was left in English: {0}")
    @MethodSource("englishFiles")
    void isTranslated(Path english) throws IOException {
        Properties translated = read(russian(english));
        var same = new ArrayList<String>();
        read(english)
                .forEach(
                        (key, text) -> {
                            String words = ((String) text).replaceAll("\\{[^}]*}|" + KEYS, "");
                            boolean any = Pattern.compile("[a-z]{4}").matcher(words).find();
                            if (any && text.equals(translated.getProperty((String) key)))
                                same.add((String) key);
                        });
        same.remove("title");
        same.removeIf(key -> key.endsWith(".source"));
        assertEquals(List.of(), same);
    }

    @ParameterizedTest(name = "a picture is called by several words: {0}")
    @MethodSource("allFiles")
    void pictureHasOneRussianWord(Path file) throws IOException {
        Pattern other = Pattern.compile("(?iu)рисун(ок|к)|картинк");
        var found = new TreeSet<String>();
        read(file)
                .forEach(
                        (key, text) -> {
                            if (other.matcher((String) text).find()) found.add(key + "=" + text);
                        });
        assertEquals(new TreeSet<>(), found);
    }

    @Test
    @DisplayName("what was undone is done again by several words")
    void redoHasOneRussianWord() throws IOException {
        var words = new TreeSet<String>();
        for (Path file : allFiles())
            if (file.toString().endsWith("_ru.properties"))
                read(file)
                        .forEach(
                                (key, text) -> {
                                    String first = ((String) text).replace("&", "").split(" ")[0];
                                    if (((String) key).matches("(.*\\.)?redo(\\.(hint|name))?")
                                            && !first.equals("↷")) words.add(first);
                                });
        assertEquals(Set.of("Повторить"), words);
    }

    private static Path russian(Path english) {
        String name = english.getFileName().toString();
        return english.resolveSibling(name.replace(".properties", "_ru.properties"));
    }

    private static Properties read(Path file) throws IOException {
        var properties = new Properties();
        try (var in = Files.newBufferedReader(file)) {
            properties.load(in);
        }
        return properties;
    }
}
