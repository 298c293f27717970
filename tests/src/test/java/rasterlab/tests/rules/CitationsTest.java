package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
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
import rasterlab.tests.Repository;

/**
 * A work is cited in one form: its authors, title, place and year; only chapter and page differ.
 */
class CitationsTest {
    private static final Pattern COMMENT = Pattern.compile("/\\*\\*.*?\\*/", Pattern.DOTALL);
    private static final String AUTHOR =
            "(?:[A-Z]\\.[- ]?)+ ?(?:[vV]an )?[A-Z][\\p{L}'-]+(?: Loan)?";
    private static final Pattern CITATION =
            Pattern.compile(
                    AUTHOR
                            + "(?:(?:, | and )"
                            + AUTHOR
                            + ")*, (?<title>[A-Z][^,;]+(?:, version \\d\\.\\d)?)"
                            + "(?:, [^;]{0,80}?)?,? (?:19|20)\\d\\d\\b");

    /** Names of the books whose authors are left out, or that have gone by another name. */
    private static final Pattern COINED =
            Pattern.compile("(?:Kazantsev|Ponomarev), (?!Foundations of|Computer graphics \\()");

    @Test
    void everyWorkHasOneForm() throws IOException {
        var forms = new TreeMap<String, TreeSet<String>>();
        var coined = new ArrayList<String>();
        for (Path file : Repository.sources(".java"))
            for (String comment : comments(Repository.text(file)).toList()) {
                collect(comment, forms);
                if (COINED.matcher(comment).find())
                    coined.add(Repository.root().relativize(file) + ": " + comment);
            }
        assertTrue(forms.size() > 40, "only " + forms.size() + " works were found");
        assertEquals(
                List.of(),
                several(forms),
                "search the sources for these citations and write each work in one form");
        assertEquals(List.of(), coined, "cite the book by author, title, place and year");
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
