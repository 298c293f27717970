package rasterlab.app.chart;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LeaderColumnTest {
    private static LeaderColumn.LeaderLabel label(double x, double y) {
        return new LeaderColumn.LeaderLabel("a", x, y, Color.BLACK, Color.BLACK);
    }

    private static void assertNothingCrosses(List<LeaderColumn.LeaderLabel> labels) {
        labels.sort(Comparator.comparingDouble(LeaderColumn.LeaderLabel::y));
        List<LeaderColumn.LabelRow> rows = new LeaderColumn(labels, 800, 40, 640).rows();
        for (int i = 0; i < rows.size(); i++) {
            assertTrue(rows.get(i).y() >= 40 && rows.get(i).y() <= 640);
            for (int j = 0; j < i; j++) {
                assertTrue(Math.abs(rows.get(i).y() - rows.get(j).y()) > 15, "rows overlap");
                assertFalse(
                        line(labels, rows, i).intersectsLine(line(labels, rows, j)), i + ", " + j);
            }
        }
    }

    private static Line2D line(
            List<LeaderColumn.LeaderLabel> labels, List<LeaderColumn.LabelRow> rows, int i) {
        LeaderColumn.LeaderLabel from = labels.get(i);
        return new Line2D.Double(from.x(), from.y(), rows.get(i).x(), rows.get(i).y());
    }

    @Test
    void noLineToANameCrossesAnother() {
        for (int seed = 0; seed < 200; seed++) {
            var random = new Random(seed);
            var labels = new ArrayList<LeaderColumn.LeaderLabel>();
            for (int i = 0; i < 15; i++)
                labels.add(label(90 + 700 * random.nextDouble(), 40 + 600 * random.nextDouble()));
            assertNothingCrosses(labels);
        }
    }

    @Test
    void fifteenPointsInARowHaveLinesThatDoNotCross() {
        var labels = new ArrayList<LeaderColumn.LeaderLabel>();
        for (int i = 0; i < 15; i++) labels.add(label(100 + 37 * (i * 7 % 15), 600));
        assertNothingCrosses(labels);
    }
}
