package rasterlab.engine.pipeline.surface;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.color.Levels;
import rasterlab.engine.pipeline.FrameBytes;
import rasterlab.engine.pipeline.fast.Culling;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.shape.TriangleGrid;
import rasterlab.engine.transform.GlMatrices;

class SurfacesTest {
    private static final TriangleMesh TORUS = TriangleGrid.torus(100, 25);

    /** A mesh of more triangles than the picture has pixels. */
    private static final TriangleMesh CROWDED = TriangleGrid.torus(200, 100);

    /** The near plane and a plane of the user cut the torus. */
    private static final TriangleView VIEW =
            new TriangleView(
                    new Matrix4d().translate(0, 0, -1.9).rotateX(-0.9),
                    GlMatrices.perspective(60, 1.6, 1, 5),
                    List.of(new double[] {1, 0, 0, 0.8}),
                    Culling.NONE);

    private static DepthRaster draw(int threads, Surface surface) {
        var out = new DepthRaster(160, 100);
        try (var pipeline = new TrianglePipeline(threads)) {
            pipeline.drawOn(0xFF203040, TORUS, VIEW, surface, out, () -> false);
        }
        return out;
    }

    @ParameterizedTest(name = "the picture of {0} threads differs from that of one")
    @ValueSource(ints = {2, 5})
    void isTheSameOnAnyNumberOfThreads(int threads) {
        for (Surface surface : LitSurfaces.all()) {
            var one = draw(1, surface);
            var many = draw(threads, surface);
            assertArrayEquals(one.raster().argb(), many.raster().argb(), surface.toString());
            assertArrayEquals(one.depth(), many.depth(), surface.toString());
        }
    }

    /** All into one picture, as a scene of several bodies is drawn. */
    @ParameterizedTest(name = "{0} threads: a later frame allocates")
    @ValueSource(ints = {1, 2})
    @Tag("slow")
    void allocatesNothingAfterTheFirstFrame(int threads) {
        var out = new DepthRaster(160, 100);
        var surfaces = LitSurfaces.all();
        try (var pipeline = new TrianglePipeline(threads)) {
            FrameBytes.assertNoneInLaterFrames(
                    () -> {
                        for (int k = 0; k < surfaces.size(); k++) {
                            pipeline.drawOn(7, TORUS, VIEW, surfaces.get(k), out, () -> false);
                            pipeline.drawOn(7, CROWDED, VIEW, surfaces.get(k), out, () -> false);
                        }
                    });
        }
    }

    /** Four corners of a wall that faces the eye: light from the lamp differs at each. */
    @Test
    void lightOfPixelsAndOfVerticesIsThatOfTheFormula() {
        var view = new TriangleView(new Matrix4d(), GlMatrices.perspective(90, 1, 1, 9));
        var wall =
                TriangleMesh.of(
                                new float[] {-3, 3, 3, -3},
                                new float[] {-3, -3, 3, 3},
                                new float[] {-2, -2, -2, -2},
                                new int[] {0, 1, 2, 0, 2, 3})
                        .withNormals(new float[4], new float[4], new float[] {1, 1, 1, 1});
        var lighting = LitSurfaces.lighting();
        var out = new DepthRaster(64, 64);
        try (var pipeline = new TrianglePipeline(1)) {
            var phong = new Surface.PerPixel(new LitPixels(lighting));
            pipeline.drawOn(7, wall, view, phong, out, () -> false);
            for (int i = 0; i < 64 * 64; i++) {
                double x = (i % 64 + 0.5) / 16 - 2;
                double y = 2 - (i / 64 + 0.5) / 16;
                assertNear(lighting.argb(x, y, -2, 0, 0, 1, false), out.raster().argb()[i], i);
            }
            var flat = new Surface.Flat(new LitVertices(lighting));
            pipeline.drawOn(7, wall, view, flat, out, () -> false);
            int third = lighting.argb(3, 3, -2, 0, 0, 1, false);
            assertEquals(Levels.HIGHEST, third >>> 24);
            assertNear(third, out.raster().argb(60, 50), 0);
        }
    }

    private static void assertNear(int expected, int actual, int pixel) {
        for (int shift = 0; shift < 32; shift += 8)
            assertEquals(
                    expected >> shift & 255, actual >> shift & 255, 1, "channel of pixel " + pixel);
    }

    /** A triangle cut by a plane of the user keeps the colour of the vertex that is cut off. */
    @Test
    void aClippedFlatTriangleKeepsItsColor() {
        var view =
                new TriangleView(
                        new Matrix4d(),
                        GlMatrices.ortho(-1, 1, -1, 1, 0, 2),
                        List.of(new double[] {-1, 0, 0, 0}),
                        Culling.NONE);
        float[] one = {1, 1, 1};
        var triangle =
                TriangleMesh.of(
                                new float[] {-1, -1, 1},
                                new float[] {-1, 1, 0},
                                new float[] {-1, -1, -1},
                                new int[] {0, 1, 2})
                        .withColors(new float[] {0, 0, 1}, new float[] {1, 1, 0}, one, one);
        var out = new DepthRaster(8, 8);
        try (var pipeline = new TrianglePipeline(1)) {
            var own = new Surface.Flat(block -> {});
            pipeline.drawOn(7, triangle, view, own, out, () -> false);
            assertEquals(0xFFFF00FF, out.raster().argb(3, 4));
            var pixels = new Surface.PerPixel(new ColoredPixels()).over(own);
            pipeline.drawOn(7, triangle, view, pixels, out, () -> false);
            assertEquals(0xFFFF00FF, out.raster().argb(3, 4));
        }
    }

    @Test
    void aBareMeshHasNoNormalsOfTheMeshBefore() {
        var out = new DepthRaster(160, 100);
        var bare =
                TriangleMesh.of(
                        new float[] {-1, 1, 0},
                        new float[] {-1, -1, 1},
                        new float[3],
                        new int[] {0, 1, 2});
        Surface seen =
                new Surface.Flat(
                        block ->
                                block.red[2] =
                                        Math.abs(block.nx[0])
                                                + Math.abs(block.ny[1])
                                                + Math.abs(block.nz[2]));
        try (var pipeline = new TrianglePipeline(1)) {
            pipeline.drawOn(7, TORUS, VIEW, LitSurfaces.gouraud(), out, () -> false);
            pipeline.drawOn(7, bare, VIEW, seen, out, () -> false);
        }
        assertEquals(0xFF00FFFF, out.raster().argb(80, 50));
    }
}
