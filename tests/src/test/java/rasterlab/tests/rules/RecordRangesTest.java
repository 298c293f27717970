package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/** A record checks each number whose range its comment promises. */
class RecordRangesTest {
    /** Records that the fastest loops make; strike off what is checked, add none. */
    private static final Set<String> UNCHECKED = Set.of("LineSection.n", "LineSection.remainder");

    private static final Pattern RECORD =
            Pattern.compile(
                    "/\\*\\*((?:(?!\\*/).)*)\\*/\\s*(?:@\\w+(?:\\([^)]*\\))?\\s*)*"
                            + "(?:(?:public|private|protected|static) )*"
                            + "record (\\w+)(?:<[^(]*>)?\\s*\\(([^{]*)\\{",
                    Pattern.DOTALL);

    private static final Pattern NUMBER = Pattern.compile("\\b(?:int|long|float|double) (\\w+)");

    private static final Pattern RANGE =
            Pattern.compile(
                    "\\bfrom (?:[−-]?\\d|\\{@value)"
                            + "|(?:[−-]?\\d[\\d.]*|\\{@value[^}]*\\}) to (?:[−-]?\\d|\\{@value)"
                            + "|\\bat least (?:\\d|\\{@value)|\\d or more|\\babove \\d|\\bin \\["
                            + "|\\bnot negative|\\bpositive"
                            + "|\\d to \\{@(?:code|link)|(?:^|[,:] )\\d(?:, \\d)* or \\d\\b");

    @Test
    @DisplayName("a record lets in what its comment rules out")
    void everyPromisedRangeIsChecked() {
        var unchecked = new ArrayList<String>();
        int promised = 0;
        for (Path file : Repository.sources(".java")) {
            String path = Repository.root().relativize(file).toString();
            if (!path.contains("/src/main/")) continue;
            List<Promise> found = promises(Repository.text(file));
            promised += found.size();
            for (Promise one : found)
                if (!one.checked) unchecked.add(one.name + "' (" + path + "): " + one.range);
        }
        assertTrue(promised > 80, "only " + promised + " promised ranges were found");
        var names = new TreeSet<String>();
        var fresh = new ArrayList<String>();
        for (String each : unchecked) {
            String name = each.substring(0, each.indexOf('\''));
            names.add(name);
            if (!UNCHECKED.contains(name)) fresh.add("'" + each);
        }
        assertEquals(
                "",
                String.join("\n", fresh),
                "a compact constructor must check these by rasterlab.engine.range.Bounds or by a"
                        + " condition of its own");
        assertEquals(UNCHECKED, names, "these are checked or gone: strike them off UNCHECKED");
    }

    @Test
    @DisplayName("the rule does not see a promise, or a check")
    void seesPromisesAndChecks() {
        String text =
                """
                /**
                 * A thing.
                 *
                 * @param a from 0 to 9
                 * @param b any number
                 * @param c at least 1, and more
                 *     words
                 */
                public record Thing(int a, int b, double c) {
                    public Thing {
                        if (a < 0 || a > 9) throw new IllegalArgumentException();
                    }
                }
                """;
        assertEquals(
                List.of(
                        new Promise("Thing.a", "from 0 to 9", true),
                        new Promise("Thing.c", "at least 1, and more words", false)),
                promises(text));
    }

    /**
     * A component whose comment promises a range.
     *
     * @param checked whether a compact constructor names it
     */
    private record Promise(String name, String range, boolean checked) {}

    private static List<Promise> promises(String text) {
        var promises = new ArrayList<Promise>();
        Matcher record = RECORD.matcher(text);
        while (record.find()) {
            String name = record.group(2);
            String check = compactConstructor(name, text.substring(record.end()));
            Matcher number = NUMBER.matcher(record.group(3));
            while (number.find()) {
                String component = number.group(1);
                String said = paramText(component, record.group(1));
                if (!RANGE.matcher(said).find()) continue;
                boolean checked = Pattern.compile("\\b" + component + "\\b").matcher(check).find();
                promises.add(new Promise(name + "." + component, said, checked));
            }
        }
        return promises;
    }

    private static String paramText(String component, String comment) {
        String words = comment.replaceAll("\\s*\\n\\s*\\*?\\s*", " ");
        Matcher said = Pattern.compile("@param " + component + " (.*?)(?= @|$)").matcher(words);
        return said.find() ? said.group(1).strip() : "";
    }

    /**
     * The body of the compact constructor, to the first line that closes it; empty where the record
     * has none.
     */
    private static String compactConstructor(String name, String body) {
        Matcher constructor =
                Pattern.compile(
                                "\\n( +)(?:public )?" + name + " \\{\\n(.*?)\\n\\1\\}",
                                Pattern.DOTALL)
                        .matcher(body);
        return constructor.find() ? constructor.group(2) : "";
    }
}
