package rasterlab.engine.pipeline.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.joml.Matrix4d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import rasterlab.engine.pipeline.fast.Blending;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.transform.GlMatrices;

/** Sheets over the whole of a picture of one pixel, in the order they are drawn. */
class BlendedPixelsTest {
    private static final TriangleView VIEW =
            new TriangleView(new Matrix4d(), GlMatrices.ortho(-1, 1, -1, 1, 0, 10));
    private static final TrianglePipeline PIPELINE = new TrianglePipeline(1);
    private static final int BLACK = 0xFF000000;

    private final DepthRaster out = new DepthRaster(1, 1);

    @AfterAll
    static void stop() {
        PIPELINE.close();
    }

    /** Sheets of {red, green, alpha, distance} in one mesh. */
    private static TriangleMesh sheets(float[]... sheets) {
        int n = sheets.length;
        float[][] v = new float[7][3 * n];
        int[] triangles = new int[3 * n];
        for (int i = 0; i < 3 * n; i++) {
            float[] sheet = sheets[i / 3];
            triangles[i] = i;
            v[0][i] = i % 3 == 1 ? 3 : -1;
            v[1][i] = i % 3 == 2 ? 3 : -1;
            v[2][i] = -sheet[3];
            v[3][i] = sheet[0];
            v[4][i] = sheet[1];
            v[6][i] = sheet[2];
        }
        return TriangleMesh.of(v[0], v[1], v[2], triangles).withColors(v[3], v[4], v[5], v[6]);
    }

    private int draw(Blending blending, float[]... sheets) {
        var surface = new Surface.PerPixel(new ColoredPixels()).with(blending);
        PIPELINE.drawOn(BLACK, sheets(sheets), VIEW, surface, out, () -> false);
        return out.raster().argb()[0];
    }

    private static float[] red(double alpha, double distance) {
        return new float[] {1, 0, (float) alpha, (float) distance};
    }

    private static float[] green(double alpha, double distance) {
        return new float[] {0, 1, (float) alpha, (float) distance};
    }

    @Test
    void theNearerSheetIsMixedOverTheFartherOne() {
        // 255·0.6 = 153; 153·0.4 = 61.2; 255·0.6·… : red is behind, green before it.
        assertEquals(0xFF3D9900, draw(Blending.OVER, red(0.6, 5), green(0.6, 4)));
    }

    @Test
    void aFartherSheetThatComesLaterIsHiddenWhereDepthIsWritten() {
        assertEquals(0xFF009900, draw(Blending.OVER, green(0.6, 4), red(0.6, 5)));
    }

    @Test
    void glassHidesNothing() {
        assertEquals(0xFF993D00, draw(Blending.GLASS, green(0.6, 4), red(0.6, 5)));
        assertEquals(DepthRaster.FARTHEST, out.depth()[0]);
    }

    @Test
    void whatTheAlphaTestDropsWritesNoDepth() {
        var holes = Blending.OPAQUE.dropBelow(128);
        assertEquals(0xFFFF0000, draw(holes, green(0.4, 4), red(0.6, 5)));
    }

    @Test
    void oneMeshInOneBatchEndsWithTheNearest() {
        var opaque = Blending.OPAQUE.dropBelow(1);
        assertEquals(0xFF00FF00, draw(opaque, red(1, 5), green(1, 4), red(1, 6)));
    }

    @Test
    void withoutMixingAlphaCountsForNothing() {
        assertEquals(0xFFFF0000, draw(Blending.OPAQUE, red(0.2, 5)));
    }

    @Test
    void overAClearPictureAlphaIsThatOfTheSheet() {
        var surface = new Surface.PerPixel(new ColoredPixels()).with(Blending.OVER);
        PIPELINE.drawOn(0, sheets(red(0.6, 5)), VIEW, surface, out, () -> false);
        assertEquals(0x99990000, out.raster().argb()[0]);
    }

    @Test
    void refusesAnAlphaThatNoPixelHas() {
        var thrown =
                assertThrows(IllegalArgumentException.class, () -> Blending.OPAQUE.dropBelow(256));
        assertEquals("least alpha must be from 0 to 255, got 256", thrown.getMessage());
    }

    @Test
    void withoutDepthTheLastSheetWins() {
        draw(Blending.OPAQUE, red(1, 1));
        float near = out.depth()[0];
        var surface = new Surface.PerPixel(new ColoredPixels());
        var later = surface.with(Blending.OPAQUE.withoutDepth());
        PIPELINE.draw(sheets(green(1, 5)), VIEW, later, out, () -> false);
        assertEquals(0xFF00FF00, out.raster().argb()[0]);
        assertEquals(near, out.depth()[0], "a depth was written");
    }

    @Test
    void sheetThatWritesNoDepthHidesNothing() {
        assertEquals(0xFF00FF00, draw(Blending.OPAQUE.withoutWriting(), red(1, 1), green(1, 5)));
    }

    @Test
    void depthIsNotWrittenUntested() {
        assertThrows(IllegalArgumentException.class, () -> new Blending(0, false, true, false));
    }
}
