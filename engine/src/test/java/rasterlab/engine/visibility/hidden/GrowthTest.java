package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.function.ToLongFunction;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.visibility.VisibilityWork;

/** Exponents of the work on small sizes; the bounds are wide. */
class GrowthTest {
    private static final long SEED = 1974;

    @Test
    @DisplayName("textbook's painter does not compare each face with each")
    void textbookPainterComparesByTheSquareOfTheFaces() {
        int[] sizes = {32, 64, 128};
        var work = new long[3];
        for (int i = 0; i < 3; i++)
            work[i] = work("painter-textbook", sizes[i], 40, VisibilityWork::comparisons);
        var growth = new Growth("painter-textbook", Growth.Axis.FACES_OF_ONE_SIZE, sizes, work);
        assertEquals(2, growth.exponent(), 0.2);
    }

    @Test
    @DisplayName("z-buffer does not test each pixel of each face")
    void depthTestsGrowWithThePixels() {
        int[] heights = {30, 60, 120};
        var sizes = new int[3];
        var work = new long[3];
        for (int i = 0; i < 3; i++) {
            sizes[i] = heights[i] * heights[i] * 4 / 3;
            work[i] = work("zfloat", 64, heights[i], VisibilityWork::depthTests);
        }
        var growth = new Growth("zfloat", Growth.Axis.PIXELS, sizes, work);
        assertEquals(1, growth.exponent(), 0.15);
    }

    private static long work(
            String method, int faces, int height, ToLongFunction<VisibilityWork> counted) {
        var mesh = ScatteredTriangles.mesh(faces, 50, SEED);
        var view = ScatteredTriangles.seen(mesh, height * 4 / 3, height);
        var drawn = DrawnFaces.by(new Visibilities().named(method).implementation(), view);
        return counted.applyAsLong(drawn.work());
    }
}
