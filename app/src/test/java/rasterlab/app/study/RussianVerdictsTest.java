package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.VerdictDetail;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;

/** What is wrong with an answer, or why a method refuses, is told in Russian for every hazard. */
@Tag("slow")
class RussianVerdictsTest {
    private static final Pattern ENGLISH =
            Pattern.compile(
                    "(?<![/.`-])\\b[a-z]{2,} [a-z]{2,}\\b"
                            + "|(?<= )(an?|and|got|is|of|or|the|to)(?= )|\\d\\.\\d|Infinity");

    static Stream<Named<Topic<?, ?, ?>>> topics() {
        return Topics.all().stream().map(topic -> Named.of(topic.name(), topic));
    }

    /** A crash is told in Java's own words. */
    @ParameterizedTest(name = "a refusal or a deviation is told in English: {0}")
    @MethodSource("topics")
    void isRussian(Topic<?, ?, ?> topic) {
        List<String> english =
                HazardMatrix.judged(topic, HazardTrial.WALL_LIMIT).cells().stream()
                        .map(cell -> cell.verdict().detail())
                        .filter(detail -> !detail.startsWith("java."))
                        .map(detail -> VerdictDetail.said(Language.RUSSIAN, detail))
                        .filter(said -> ENGLISH.matcher(said).find())
                        .distinct()
                        .toList();
        assertEquals(List.of(), english);
    }
}
