package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.cli.Ran;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/**
 * Every verdict that the command prints is the recorded one, and what is wrong with an answer, or
 * why a method refuses, is told in Russian. The table takes long, so both look at one.
 */
@Tag("slow")
class RussianVerdictsTest {
    private static final Pattern ENGLISH =
            Pattern.compile(
                    "(?<![/.`-])\\b[a-z]{2,} [a-z]{2,}\\b"
                            + "|(?<= )(an?|and|got|is|of|or|the|to)(?= )|\\d\\.\\d|Infinity");

    private static JsonNode table;

    @BeforeAll
    static void tryEveryMethodOnEveryHazard() throws Exception {
        table = new ObjectMapper().readTree(Ran.lab("hazards", "--json").out());
    }

    @Test
    void jsonHasACellForEachPair() {
        assertTrue(table.path("asRecorded").asBoolean(), table.toString());
        for (JsonNode cell : table.path("verdicts"))
            assertEquals(cell.path("recorded"), cell.path("verdict"), cell.toString());
        long pairs =
                Topics.all().stream()
                        .mapToLong(topic -> (long) topic.methods().size() * topic.hazards().size())
                        .sum();
        assertEquals(pairs, table.path("verdicts").size());
    }

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name);
    }

    /** A crash is told in Java's own words. */
    @ParameterizedTest(name = "a refusal or a deviation is told in English: {0}")
    @MethodSource("topics")
    void isRussian(String topic) {
        List<String> details =
                table.path("verdicts").findParents("topic").stream()
                        .filter(cell -> cell.path("topic").asText().equals(topic))
                        .map(cell -> cell.path("detail").asText())
                        .toList();
        assertFalse(details.isEmpty(), "no verdict");
        List<String> english =
                details.stream()
                        .filter(detail -> !detail.startsWith("java."))
                        .map(detail -> VerdictDetail.translated(Language.RUSSIAN, detail))
                        .filter(said -> ENGLISH.matcher(said).find())
                        .distinct()
                        .toList();
        assertEquals(List.of(), english);
    }
}
