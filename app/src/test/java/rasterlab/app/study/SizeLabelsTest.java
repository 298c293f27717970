package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.image.BufferedImage;
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
    @Test
    void labelsOfMethodsAtOnePlaceStandApart() {
        List<MatchResult> labels = labels(3, 3);
        int across = distance(labels, 1);
        int down = distance(labels, 2);
        assertTrue(across >= 35 || down >= 11, "labels are " + across + ", " + down + " apart");
    }

    @Test
    void labelsOfNeighboursAreNotReadAsOneNumber() {
        int width = widthOfALabel();
        for (double cost = 3.1; cost < 3.3; cost += 0.003) {
            List<MatchResult> labels = labels(3, cost);
            int across = distance(labels, 1);
            assertTrue(
                    across >= width + 3 || distance(labels, 2) >= 11,
                    "a gap of " + (across - width) + " at cost " + cost);
        }
    }

    private static int widthOfALabel() {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        return image.createGraphics()
                .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 12))
                .stringWidth("77777");
    }

    /** Two methods' labels, of sizes found nowhere else in the picture. */
    private static List<MatchResult> labels(double... costs) {
        List<Measurement> points =
                IntStream.range(0, costs.length)
                        .mapToObj(i -> measured("m" + i, costs[i]))
                        .toList();
        var study = new Study("line", "pixel", "pixels", points);
        String svg = new String(StudyChart.svg(study, Language.ENGLISH), StandardCharsets.UTF_8);
        List<MatchResult> labels =
                Pattern.compile("<text[^>]*? x=\"(\\d+)\"[^>]*? y=\"(\\d+)\"[^>]*>77777<")
                        .matcher(svg)
                        .results()
                        .toList();
        assertEquals(2, labels.size(), "both labels are drawn");
        return labels;
    }

    private static Measurement measured(String method, double cost) {
        return new Measurement(
                method,
                "w",
                77_777,
                new Cost(cost, cost, cost, Map.of()),
                new Deviation(2, 0, 0, 1, ""),
                Verdict.Kind.WRONG,
                "");
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
