package rasterlab.engine.polygon.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;

/** Very many polygons against the reference: all of them with {@code -Drasterlab.full=true}. */
@Tag("slow")
class PolygonFullTest {
    private static final int POLYGONS = Boolean.getBoolean("rasterlab.full") ? 1_000_000 : 5_000;
    private static final int SIDE = 24;
    private static final long SEED = 1967;

    @Test
    void noPixelOfManyPolygonsIsWrong() {
        var random = new Random(SEED);
        for (int i = 0; i < POLYGONS; i++) {
            var task =
                    PolygonTask.of(
                            FillRule.values()[i % 2], SIDE, SIDE, corners(3 + i % 8, random));
            List<Integer> exact = new ArrayList<>();
            new ExactFill(task).fill((y, from, to) -> exact.addAll(List.of(y, from, to)));
            assertEquals(exact, spans(new ScanlinePolygon(), task), "seed 1967, polygon " + i);
            assertEquals(exact, spans(new EdgeFunctionPolygon(), task), "seed 1967, polygon " + i);
        }
    }

    /** Near centres and corners of pixels, where rounding would decide. */
    private static double[] corners(int corners, Random random) {
        var values = new double[2 * corners];
        for (int i = 0; i < values.length; i++) {
            double half = random.nextInt(2 * SIDE + 9) / 2.0 - 2;
            double ulps = (random.nextInt(5) - 2) * Math.ulp(half);
            values[i] = random.nextInt(3) == 0 ? random.nextDouble() * SIDE : half + ulps;
        }
        return values;
    }

    private static List<Integer> spans(PolygonFiller method, PolygonTask task) {
        List<Integer> spans = new ArrayList<>();
        method.fill(
                task.x(),
                task.y(),
                task.rule(),
                task.width(),
                task.height(),
                (y, from, to) -> spans.addAll(List.of(y, from, to)));
        return spans;
    }
}
