package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.tests.Repository;

/** Keeps a Russian line from breaking before a dash or between a number and what it counts. */
class RussianTypographyTest {
    private static final String UNITS =
            "%|МиБ|ГиБ|КиБ|мс|мкс|нс|с|мин|пикс|px|байт[а-я]*|градус[а-я]*";

    /** Finds a space that must be U+00A0. */
    private static final Pattern LOOSE =
            Pattern.compile(
                    "(?<=\\S) (?=—)|(?<=№) |(?<=[\\d}]) (?=(?:"
                            + UNITS
                            + ")(?![\\p{L}\\d_]))|(?<=\\d) (?=\\d{3}(?!\\d))");

    /** Code and formulas, in which a space is a space. */
    private static final Pattern LITERAL = Pattern.compile("`[^`]*`|\\$[^$]*\\$");

    @Test
    void everyRussianTextHoldsTogether() throws IOException {
        var found = new ArrayList<String>();
        for (Path file : russian()) {
            boolean block = false;
            List<String> lines = Files.readAllLines(file);
            for (int i = 0; i < lines.size(); i++) {
                String line = lines.get(i);
                if (line.startsWith("```")) block = !block;
                if (!block && !isLiteral(file, line) && loose(line))
                    found.add(Repository.root().relativize(file) + ":" + (i + 1) + " " + line);
            }
        }
        assertEquals(
                List.of(),
                found,
                "write U+00A0 before a dash, after №, between a number and its unit, in a number");
    }

    @ParameterizedTest
    @CsvSource({
        "=верно — и точно, true",
        "=верно\u00a0— и точно, false",
        "=решение № 3, true",
        "=за {0} мс, true",
        "=46 341 пиксель, true",
        "=46\u00a0341 пиксель, false",
        "запуск `a — b` без имени, false"
    })
    void aLooseSpaceIsFound(String line, boolean loose) {
        assertEquals(loose, loose(line));
    }

    private static boolean loose(String line) {
        return LOOSE.matcher(LITERAL.matcher(line).replaceAll("x")).find();
    }

    /** Whether nobody reads the line as prose: an indented block of code, a comment of a bundle. */
    private static boolean isLiteral(Path file, String line) {
        return line.startsWith("    ")
                || line.startsWith("#") && file.toString().endsWith(".properties");
    }

    private static List<Path> russian() throws IOException {
        var files = new ArrayList<Path>();
        for (String page : List.of("README.ru.md", "exercises/README.ru.md", "engine/models.ru.md"))
            files.add(Repository.root().resolve(page));
        for (String module : Repository.MODULES) {
            Path resources = Repository.root().resolve(module).resolve("src/main/resources");
            if (!Files.exists(resources)) continue;
            try (var all = Files.walk(resources)) {
                all.filter(file -> file.toString().matches(".*(_ru\\.properties|\\.ru\\.md)"))
                        .forEach(files::add);
            }
        }
        return files;
    }
}
