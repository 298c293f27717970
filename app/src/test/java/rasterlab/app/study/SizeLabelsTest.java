package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class SizeLabelsTest {
    /** Two methods at one place, of sizes found nowhere else in the picture. */
    @Test
    void labelsOfMethodsAtOnePlaceStandApart() {
        List<Measurement> points =
                IntStream.range(0, 2)
                        .mapToObj(
                                i ->
                                        new Measurement(
                                                "method" + i,
                                                "w",
                                                77_777,
                                                new Cost(3, 3, 3, Map.of()),
                                                new Deviation(2, 0, 0, 1, ""),
                                                Verdict.Kind.WRONG,
                                                ""))
                        .toList();
        var study = new Study("line", "pixel", "pixels", points);
        String svg = new String(StudyChart.svg(study, Language.ENGLISH), StandardCharsets.UTF_8);
        List<MatchResult> labels =
                Pattern.compile("<text[^>]*? x=\"(\\d+)\"[^>]*? y=\"(\\d+)\"[^>]*>77777<")
                        .matcher(svg)
                        .results()
                        .toList();
        assertEquals(2, labels.size(), "both labels are drawn");
        int across = distance(labels, 1);
        int down = distance(labels, 2);
        assertTrue(across >= 35 || down >= 11, "labels are " + across + ", " + down + " apart");
    }

    private static int distance(List<MatchResult> labels, int group) {
        return Math.abs(
                Integer.parseInt(labels.get(0).group(group))
                        - Integer.parseInt(labels.get(1).group(group)));
    }

    @Test
    void longPowersOfTenAreShort() {
        assertEquals("10⁷", LogTicks.size(10_000_000));
        assertEquals("1000", LogTicks.size(1000));
        assertEquals("65536", LogTicks.size(65536));
    }
}
