package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.tests.Repository;

/** Keeps words that mean something else, or nothing, out of what people read. */
class BannedWordsTest {
    /**
     * A word that must not come back.
     *
     * @param wrong what must not stand in a text
     * @param right what to write instead, and why
     * @param caught a text that had it
     */
    private record Banned(Pattern wrong, String right, String caught) {
        static Banned of(String wrong, String right, String caught) {
            int flags = Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;
            return new Banned(Pattern.compile(wrong, flags), right, caught);
        }

        @Override
        public String toString() {
            return wrong.pattern();
        }
    }

    static Stream<Banned> words() {
        return Stream.of(
                Banned.of(
                        "рассеянн",
                        "диффузный: the course's book calls ambient light «рассеянный»",
                        "kd=Рассеянный"),
                Banned.of(
                        "[;(,] ?обычно",
                        "по умолчанию: «обычно» means usually",
                        "zoom=масштаб; обычно 1"),
                Banned.of("светится", "освещается: light falls on it", "изнанка светится"),
                Banned.of(
                        "=на грани$",
                        "на границе, чуть за пределом: «грань» is the face of a body",
                        "stretch.edge=на грани"),
                Banned.of(
                        "мировая, объекта, наблюдателя",
                        "мировая, объектная, наблюдателя и экранная: the source's own title",
                        "«Системы координат: мировая, объекта, наблюдателя и экрана»"),
                Banned.of(
                        "(не)?верн\\p{L}+ тест",
                        "тест пройден, тест не пройден: an answer is wrong, not the test",
                        "Выберите неверный тест"),
                Banned.of(
                        "(right|wrong) cases?\\b",
                        "passed case, failed case: an answer is wrong, not the case",
                        "Choose a wrong case"),
                Banned.of(
                        "(?-i:\\dE-?\\d)",
                        "10¹⁸, or 1e18 where it is typed: a capital E is Java's form",
                        "beyond 1.0E18: refused"),
                Banned.of(
                        "\\bis no (double|int)\\b",
                        "does not fit in a double: it is a number all the same",
                        "The difference of the ends is no double."),
                Banned.of("instead stands", "… is used instead", "no number; instead stands 0.8"),
                Banned.of(
                        "\\bwho (has )?lost\\b",
                        "a lost token is replaced: a sentence needs a subject",
                        "Makes a new token for who has lost the old one"),
                Banned.of(
                        "(пик|тек)сел(ы|ов|ам|ами|ах)(?!\\p{L})",
                        "пиксели, пикселей, as the course's book has it",
                        "все пикселы цвета фона"),
                Banned.of(
                        "(?<!\\p{L})ключ(а|у|ом|е|и|ей|ами|ах)?(?!\\p{L}| запроса)",
                        "токен: «ключ» is an Idempotency-Key, ключ запроса",
                        "entry.token=Ключ"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("words")
    void noTextHasIt(Banned banned) throws IOException {
        assertTrue(banned.wrong.matcher(banned.caught).find(), "finds not even its own example");
        var found = new ArrayList<String>();
        for (Path file : texts()) {
            List<String> lines = Files.readAllLines(file);
            for (int i = 0; i < lines.size(); i++)
                if (banned.wrong.matcher(value(lines.get(i))).find())
                    found.add(Repository.root().relativize(file) + ":" + (i + 1));
        }
        assertEquals(List.of(), found, "write " + banned.right);
    }

    /** A line of a bundle from its "=" on; any other line as it is. */
    private static String value(String line) {
        int equals = line.indexOf('=');
        return line.startsWith("#") ? "" : equals < 0 ? line : line.substring(equals);
    }

    @Test
    void bundlesOfBothLanguagesAndStatementsAreRead() throws IOException {
        List<String> names = texts().stream().map(file -> file.getFileName().toString()).toList();
        for (String name : List.of("messages.properties", "messages_ru.properties", "cases.json"))
            assertTrue(names.contains(name), name);
        for (String name : List.of("statement.en.md", "statement.ru.md", "command_ru.properties"))
            assertTrue(names.contains(name), name);
    }

    private static List<Path> texts() throws IOException {
        var texts = new ArrayList<Path>(List.of(Repository.root().resolve("README.md")));
        for (String module : Repository.MODULES) {
            Path resources = Repository.root().resolve(module).resolve("src/main/resources");
            if (!Files.exists(resources)) continue;
            try (var files = Files.walk(resources)) {
                files.filter(file -> file.toString().matches(".*\\.(properties|md|json)"))
                        .forEach(texts::add);
            }
        }
        return texts;
    }
}
