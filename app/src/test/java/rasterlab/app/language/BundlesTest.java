package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class BundlesTest {
    private static final Path ROOT = Path.of("src/main/resources/rasterlab/app");
    private static final Pattern PLACEHOLDER = Pattern.compile("\\{(\\d+)");

    /** Every English file that must say the same as its Russian one. */
    static List<Path> englishFiles() throws IOException {
        try (Stream<Path> files = Files.walk(ROOT)) {
            return files.filter(file -> file.getFileName().toString().equals("messages.properties"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest(name = "a text is missing in one language: {0}")
    @MethodSource("englishFiles")
    void hasTheSameKeysInBothLanguages(Path english) throws IOException {
        assertEquals(
                new TreeSet<>(read(english).keySet()),
                new TreeSet<>(read(russian(english)).keySet()));
    }

    @ParameterizedTest(name = "a translation drops or invents a placeholder: {0}")
    @MethodSource("englishFiles")
    void hasTheSamePlaceholdersInBothLanguages(Path english) throws IOException {
        Properties translated = read(russian(english));
        read(english)
                .forEach(
                        (key, text) ->
                                assertEquals(
                                        placeholders((String) text),
                                        placeholders(translated.getProperty((String) key)),
                                        "key " + key));
    }

    @ParameterizedTest(name = "a text was left in English: {0}")
    @MethodSource("englishFiles")
    void isTranslated(Path english) throws IOException {
        Properties translated = read(russian(english));
        var same = new ArrayList<String>();
        read(english)
                .forEach(
                        (key, text) -> {
                            String words = ((String) text).replaceAll("\\{[^}]*}", "");
                            boolean any = Pattern.compile("[a-z]{4}").matcher(words).find();
                            if (any && text.equals(translated.getProperty((String) key)))
                                same.add((String) key);
                        });
        same.remove("title");
        assertEquals(List.of(), same);
    }

    private static TreeSet<String> placeholders(String text) {
        var found = new TreeSet<String>();
        var matcher = PLACEHOLDER.matcher(text);
        while (matcher.find()) found.add(matcher.group(1));
        return found;
    }

    private static Path russian(Path english) {
        return english.resolveSibling("messages_ru.properties");
    }

    private static Properties read(Path file) throws IOException {
        var properties = new Properties();
        try (var in = Files.newBufferedReader(file)) {
            properties.load(in);
        }
        return properties;
    }
}
