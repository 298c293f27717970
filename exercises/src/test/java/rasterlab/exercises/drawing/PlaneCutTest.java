package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class PlaneCutTest {
    private static final PlaneBox BOX =
            new PlaneBox(new AxisRange(-1, 1), new AxisRange(-1, 1), true);

    @Test
    void aHugeSegmentCrossesASmallBoxWhereItDoes() {
        assertEquals(
                Optional.of(List.of(new CasePoint(-1, -0.5), new CasePoint(1, 0.5))),
                cut(-1e308, -5e307, 1e308, 5e307));
        assertEquals(
                Optional.of(List.of(new CasePoint(1, 0.25), new CasePoint(-1, 0.25))),
                cut(1.7e308, 0.25, -1.7e308, 0.25));
    }

    @Test
    void aSegmentPastACornerHasNoPart() {
        assertEquals(Optional.empty(), cut(0, 2.5, 2.5, 0));
        assertEquals(Optional.empty(), cut(2, -9, 3, 9));
    }

    @Test
    void aPolygonAroundTheBoxCoversIt() {
        PlaneFigure large = PlaneFigure.polygon(-1e308, -1e308, 1e308, -1e308, 0, 1.7e308);
        List<CasePoint> kept = new PlaneCut(BOX).polygon(large.vertices());
        for (double x : new double[] {-1, 1})
            for (double y : new double[] {-1, 1})
                assertTrue(kept.contains(new CasePoint(x, y)), kept::toString);
    }

    @Test
    void nothingIsLeftOutsideTheBox() {
        long seed = new Random().nextLong();
        var random = new Random(seed);
        for (int i = 0; i < 300; i++) {
            double[] n = new AnyNumbers(random).some(4);
            var one = new CasePoint(n[0], n[1]);
            var other = new CasePoint(n[2], n[3]);
            if (!one.isFinite() || !other.isFinite()) continue;
            for (CasePoint end : new PlaneCut(BOX).segment(one, other).orElse(List.of()))
                assertTrue(BOX.contains(end), "seed " + seed + ": " + end);
        }
    }

    private static Optional<List<CasePoint>> cut(double x0, double y0, double x1, double y1) {
        return new PlaneCut(BOX).segment(new CasePoint(x0, y0), new CasePoint(x1, y1));
    }
}
