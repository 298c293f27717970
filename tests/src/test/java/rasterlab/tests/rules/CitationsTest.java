package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.tests.Repository;

/**
 * A work is cited in one form: its authors, title, place and year; only chapter and page differ.
 *
 * <p>Comments and the English bundles share that form; the Russian bundles have one of their own.
 */
class CitationsTest {
    private static final Pattern COMMENT = Pattern.compile("/\\*\\*.*?\\*/", Pattern.DOTALL);
    private static final String AUTHOR =
            "(?:\\p{Lu}\\p{Ll}?\\.[- ]?)+ ?(?:[vV]an |ван )?\\p{Lu}[\\p{L}'-]+(?: Loan)?";
    private static final Pattern CITATION =
            Pattern.compile(
                    AUTHOR
                            + "(?:(?:, | and )"
                            + AUTHOR
                            + ")*\\)?, (?<title>\\p{Lu}[^,;]+(?:, version \\d\\.\\d)?)"
                            + "(?:, [^;]{0,80}?)?,? (?:19|20)\\d\\d\\b");

    /** Names of the books whose authors are left out, or that have gone by another name. */
    private static final Pattern COINED =
            Pattern.compile(
                    "(?:Kazantsev|Ponomarev), (?!Foundations of|Computer graphics \\()"
                            + "|(?<!\\p{Lu}\\. )(?:Kazantsev|Ponomarev|Казанцев|Пономарёв),"
                            + "|(?:Казанцев|Пономарёв), (?!Основы компьютерной|Машинная графика,)"
                            + "|course(?: text(?:book)?|'s (?:lecture text|text|article))\\b"
                            + "|course's (?:other )?textbook\\b"
                            + "|(?:лекци|учебник|текст)\\p{L}* курса|конспект\\p{L}* лекций"
                            + "|курс\\p{L}* компьютерной графики");

    @Test
    void everyWorkHasOneForm() throws IOException {
        var forms = new TreeMap<String, TreeSet<String>>();
        var coined = new ArrayList<String>();
        for (Path file : Repository.sources(".java"))
            for (String comment : comments(Repository.text(file)).toList())
                read(file, comment, forms, coined);
        for (Path file : bundles(false))
            for (String line : Files.readAllLines(file)) read(file, line, forms, coined);
        requireOneForm(forms, coined, 70);
    }

    @Test
    void everyWorkHasOneFormInRussian() throws IOException {
        var forms = new TreeMap<String, TreeSet<String>>();
        var coined = new ArrayList<String>();
        for (Path file : bundles(true))
            for (String line : Files.readAllLines(file)) read(file, line, forms, coined);
        requireOneForm(forms, coined, 40);
    }

    @ParameterizedTest(name = "{0} and {1}")
    @DisplayName("another place, year or list of authors is not seen")
    @CsvSource(
            delimiter = '|',
            value = {
                "A. Bee, C. Dee, On lines, 1965 | A. Bee and C. Dee, On lines, 1965 | false",
                "A. Bee, On lines, 1965 | A. Bee, On lines, SIGGRAPH 1965 | false",
                "A. Bee, On lines, 1965 | A. Bee, On lines, 1966 | false",
                "A. Bee, On lines, 1965, pp. 3–5 | A. Bee, On lines, 1965, chapter 2 | true",
                "A. Bee, On lines, version 1.1, 1965 | A. Bee, On lines, version 1.2, 1966 | true"
            })
    void otherFormsAreSeen(String one, String other, boolean same) {
        var forms = new TreeMap<String, TreeSet<String>>();
        collect(one, forms);
        collect(other, forms);
        assertEquals(same, several(forms).isEmpty());
    }

    @ParameterizedTest(name = "{0}")
    @DisplayName("a name of a course's book besides its own is seen")
    @ValueSource(
            strings = {
                "Kazantsev, course text on computer graphics, chapter 3",
                "the course's lecture text on clipping",
                "the course's textbook, chapter on clipping",
                "Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005",
                "Казанцев, Основы компьютерной графики для программистов, Казань, 2005",
                "А. В. Казанцев, конспект лекций, глава 7",
                "учебник курса, глава об отсечении",
                "лекции курса о триангуляции",
                "текст курса по аналитической геометрии",
                "В. В. Пономарёв, курс компьютерной графики"
            })
    void otherNamesOfTheBooksAreSeen(String name) {
        assertTrue(COINED.matcher(name).find());
    }

    /** Collects the citations of a text, and tells of a book that goes by another name there. */
    private static void read(
            Path file, String text, Map<String, TreeSet<String>> forms, List<String> coined) {
        collect(text, forms);
        if (COINED.matcher(text).find())
            coined.add(Repository.root().relativize(file) + ": " + text);
    }

    private static void requireOneForm(
            Map<String, TreeSet<String>> forms, List<String> coined, int least) {
        assertTrue(forms.size() > least, "only " + forms.size() + " works were found");
        assertEquals(
                List.of(),
                several(forms),
                "search the sources and the bundles for these and write each work in one form");
        assertEquals(List.of(), coined, "cite the book by author, title, place and year");
    }

    private static List<Path> bundles(boolean russian) throws IOException {
        var bundles = new ArrayList<Path>();
        for (String module : Repository.MODULES) {
            Path resources = Repository.root().resolve(module).resolve("src/main/resources");
            if (!Files.exists(resources)) continue;
            try (var files = Files.walk(resources)) {
                files.filter(file -> file.toString().endsWith(".properties"))
                        .filter(file -> file.toString().endsWith("_ru.properties") == russian)
                        .forEach(bundles::add);
            }
        }
        return bundles;
    }

    /** The comments of a source, each in one line. */
    private static Stream<String> comments(String source) {
        return COMMENT.matcher(source)
                .results()
                .map(found -> found.group().replaceAll("\\s*\\n\\s*\\*?\\s*", " "));
    }

    private static void collect(String comment, Map<String, TreeSet<String>> forms) {
        for (Matcher found = CITATION.matcher(comment); found.find(); )
            forms.computeIfAbsent(found.group("title"), title -> new TreeSet<>())
                    .add(found.group());
    }

    private static List<String> several(Map<String, TreeSet<String>> forms) {
        return forms.values().stream()
                .filter(all -> all.size() > 1)
                .map(all -> String.join("\n", all))
                .toList();
    }
}
