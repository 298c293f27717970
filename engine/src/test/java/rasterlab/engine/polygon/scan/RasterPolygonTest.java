package rasterlab.engine.polygon.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import rasterlab.contract.FillRule;
import rasterlab.engine.raster.Raster;

/** The picture gets the pixels that the walk sends, whatever was filled before. */
class RasterPolygonTest {
    private static final int SIDE = 40;
    private static final int MOST = 16384 * RasterPolygon.SUBPIXELS;

    private final RasterPolygon polygons = new RasterPolygon();

    @Provide
    Arbitrary<int[]> corners() {
        Arbitrary<Integer> pixel = Arbitraries.integers().between(-5, SIDE + 5);
        Arbitrary<Integer> coordinate =
                Arbitraries.oneOf(
                        pixel.map(v -> v * RasterPolygon.SUBPIXELS),
                        pixel.map(v -> v * RasterPolygon.SUBPIXELS + 1),
                        Arbitraries.integers().between(-2000, 256 * SIDE + 2000),
                        Arbitraries.integers().between(-MOST, MOST));
        return coordinate.array(int[].class).ofMinSize(0).ofMaxSize(24);
    }

    @Property(tries = 4000)
    void thePictureGetsTheWalksPixels(@ForAll("corners") int[] corners, @ForAll FillRule rule) {
        int n = corners.length / 2;
        var x = new int[n];
        var y = new int[n];
        Arrays.setAll(x, i -> corners[2 * i]);
        Arrays.setAll(y, i -> corners[2 * i + 1]);
        assertSame(x, y, rule, SIDE, SIDE);
    }

    /** Slivers across the tallest picture, where the fixed point has the most steps to drift. */
    @Property(tries = 40)
    void theTallestPictureGetsTheWalksPixels(@ForAll("corners") int[] corners) {
        int[] x = {0, 3 * 256, 37 * 256 + 1, 256};
        int[] y = {-MOST, 255, 8192 * 256, 8191 * 256 + 17};
        for (int i = 0; i < Math.min(4, corners.length); i++) x[i] = corners[i] / 8;
        assertSame(x, y, FillRule.EVEN_ODD, SIDE, 8192);
    }

    private void assertSame(int[] x, int[] y, FillRule rule, int width, int height) {
        var picture = new Raster(width, height);
        polygons.fill(x, y, x.length, rule, 7, picture);
        var expected = new int[width * height];
        new ScanlinePolygon()
                .fill(
                        pixels(x),
                        pixels(y),
                        rule,
                        width,
                        height,
                        (row, from, to) ->
                                Arrays.fill(expected, row * width + from, row * width + to, 7));
        assertEquals(-1, Arrays.mismatch(expected, picture.argb()), "cell of the first difference");
    }

    private static double[] pixels(int[] subpixels) {
        return Arrays.stream(subpixels).mapToDouble(v -> v / 256.0).toArray();
    }

    @Test
    void aCornerBeyondTheFixedPointIsRefusedAndTheNextPolygonIsRight() {
        var picture = new Raster(SIDE, SIDE);
        int[] y = {0, 0, 256};
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                polygons.fill(
                                        new int[] {0, MOST + 1, 0},
                                        y,
                                        3,
                                        FillRule.EVEN_ODD,
                                        7,
                                        picture));
        assertEquals(
                "corner 1 must be at most 16384 pixels from 0, got (4194305, 0) / 256",
                refusal.getMessage());
        assertSame(new int[] {0, 5000, 300}, new int[] {0, 700, 9000}, FillRule.NON_ZERO, 40, 40);
    }
}
