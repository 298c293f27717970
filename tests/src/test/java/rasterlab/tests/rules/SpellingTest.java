package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/**
 * Names in code are spelled as the JDK's and JOML's are, so that one search finds {@code Color} and
 * {@code color} alike. Comments and texts are British.
 */
class SpellingTest {
    /** Comments, texts and characters, in which no names of code are looked for. */
    private static final Pattern PROSE =
            Pattern.compile(
                    "\"\"\"[\\s\\S]*?\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*+\"|'(?:\\\\.|[^'\\\\\\n])++'"
                            + "|//[^\\n]*|/\\*[\\s\\S]*?\\*/");

    private static final Pattern NAME = Pattern.compile("\\w++");
    private static final Pattern BRITISH = Pattern.compile("(?i)colour|centre|grey|normalis");

    @Test
    @DisplayName("a name in code says colour, centre, grey or normalise")
    void namesAreSpelledAsTheJdkSpellsThem() {
        var found = new TreeMap<String, List<String>>();
        for (var file : Repository.sources(".java", ".kt")) {
            List<String> names = british(Repository.text(file));
            if (!names.isEmpty()) found.put(Repository.root().relativize(file).toString(), names);
        }
        assertEquals(Map.of(), found, "write color, center, gray and normalize in these names");
    }

    @Test
    @DisplayName("a British name is not seen, or a British word of a text or comment is")
    void namesAloneAreSeen() {
        String code =
                "/** The colour. */ int fillColour = 'g'; // grey\n f(\"the \\\" centre\", CENTRE);";
        assertEquals(List.of("fillColour", "CENTRE"), british(code));
        assertEquals(List.of(), british("var a = \"\"\"\n the \"grey\" one\n\"\"\";"));
    }

    /** The names of code that are spelled otherwise, each as often as it stands there. */
    private static List<String> british(String code) {
        String bare = PROSE.matcher(code).replaceAll(" ");
        return NAME.matcher(bare)
                .results()
                .map(MatchResult::group)
                .filter(name -> BRITISH.matcher(name).find())
                .toList();
    }
}
