package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.ref.WeakReference;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.FrameBytes;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.scene.shape.TriangleGrid;
import rasterlab.engine.transform.GlMatrices;

class TrianglePipelineTest {
    private static final TriangleMesh TORUS = TriangleGrid.torus(200, 50);
    private static final int WIDTH = 320;
    private static final int HEIGHT = 200;

    /** The near plane and a plane of the user cut the torus. */
    private static final TriangleView VIEW =
            new TriangleView(
                    new Matrix4d().translate(0, 0, -1.9).rotateX(-0.9),
                    GlMatrices.perspective(60, 1.6, 1, 5),
                    List.of(new double[] {1, 0, 0, 0.8}),
                    Culling.NONE);

    private static final VertexColors LIT =
            block -> {
                for (int i = 0; i < block.count; i++) {
                    block.red[i] = Math.abs(block.nx[i]);
                    block.green[i] = Math.abs(block.ny[i]);
                    block.blue[i] = Math.abs(block.nz[i]);
                }
            };

    private static final PixelColors NORMALS = normals();

    /** Far more collections than what is not held needs to be freed. */
    private static final int COLLECTIONS = 50;

    private static PixelColors normals() {
        return new PixelColors() {
            private final Set<VertexQuantity> wants =
                    Set.of(VertexQuantity.NORMAL_X, VertexQuantity.NORMAL_Z);

            @Override
            public Set<VertexQuantity> wants() {
                return wants;
            }

            @Override
            public void color(PixelBatch batch) {
                float[] x = batch.values(VertexQuantity.NORMAL_X);
                float[] z = batch.values(VertexQuantity.NORMAL_Z);
                for (int i = 0; i < batch.count; i++)
                    batch.argb[i] = (int) (x[i] * 127 + 128) << 8 | (int) (z[i] * 127 + 128);
            }
        };
    }

    private static DepthRaster draw(int threads, Surface surface) {
        var out = new DepthRaster(WIDTH, HEIGHT);
        try (var pipeline = new TrianglePipeline(threads)) {
            pipeline.drawOn(7, TORUS, VIEW, surface, out, () -> false);
        }
        return out;
    }

    @ParameterizedTest(name = "the picture of {0} threads differs from that of one")
    @ValueSource(ints = {2, 3, 8})
    @Tag("slow")
    void isTheSameOnAnyNumberOfThreads(int threads) {
        for (Surface surface :
                List.of(
                        new Surface.Smooth(LIT),
                        new Surface.Flat(LIT),
                        new Surface.PerPixel(NORMALS))) {
            var one = draw(1, surface);
            var many = draw(threads, surface);
            assertArrayEquals(one.raster().argb(), many.raster().argb());
            assertArrayEquals(one.depth(), many.depth());
        }
    }

    @ParameterizedTest(name = "{0} threads: a later frame allocates")
    @ValueSource(ints = {1, 2})
    @Tag("slow")
    void allocatesNothingAfterTheFirstFrame(int threads) {
        var out = new DepthRaster(WIDTH, HEIGHT);
        var surfaces = List.of(new Surface.Smooth(LIT), new Surface.PerPixel(NORMALS));
        for (Surface surface : surfaces)
            try (var pipeline = new TrianglePipeline(threads)) {
                FrameBytes.assertNoneInLaterFrames(
                        () -> {
                            pipeline.drawOn(7, TORUS, VIEW, surface, out, () -> false);
                            pipeline.drawOn(7, TORUS, VIEW, surface, out.raster(), () -> false);
                        });
            }
    }

    @Test
    @Tag("slow")
    void stopsSoonAndDrawsTheNextFrameRight() {
        var out = new DepthRaster(WIDTH, HEIGHT);
        var surface = new Surface.PerPixel(NORMALS);
        try (var pipeline = new TrianglePipeline(2)) {
            var asked = new AtomicInteger();
            assertThrows(
                    CancellationException.class,
                    () ->
                            pipeline.drawOn(
                                    7,
                                    TORUS,
                                    VIEW,
                                    surface,
                                    out,
                                    () -> asked.incrementAndGet() > 45));
            assertTrue(asked.get() < 50, "asked " + asked + " times after it said stop at 46");
            pipeline.drawOn(7, TORUS, VIEW, surface, out, () -> false);
        }
        assertArrayEquals(draw(1, surface).raster().argb(), out.raster().argb());
    }

    @Test
    @DisplayName("mesh, colors or picture of the last frame are held until the next is drawn")
    void dropsWhatWasDrawn() {
        try (var pipeline = new TrianglePipeline(2)) {
            for (WeakReference<?> drawn : drawOnce(pipeline)) {
                for (int k = 0; k < COLLECTIONS && drawn.get() != null; k++) System.gc();
                Object held = drawn.get();
                assertTrue(held == null, () -> held.getClass().getSimpleName() + " is held");
            }
        }
    }

    private static List<WeakReference<?>> drawOnce(TrianglePipeline pipeline) {
        var mesh = TriangleGrid.torus(20, 10);
        var colors = normals();
        var out = new DepthRaster(WIDTH, HEIGHT);
        pipeline.drawOn(7, mesh, VIEW, new Surface.PerPixel(colors), out, () -> false);
        return Stream.of(mesh, colors, out.raster(), out.raster().argb(), out.depth())
                .<WeakReference<?>>map(WeakReference::new)
                .toList();
    }

    @Test
    void reportsWhatColorsThrow() {
        Surface broken =
                new Surface.Smooth(
                        block -> {
                            throw new IllegalStateException("no light");
                        });
        var thrown = assertThrows(IllegalStateException.class, () -> draw(3, broken));
        assertEquals("no light", thrown.getMessage());
    }

    @Test
    void anEmptyMeshLeavesTheBackground() {
        var out = new DepthRaster(3, 2);
        var nothing = TriangleMesh.of(new float[0], new float[0], new float[0], new int[0]);
        try (var pipeline = new TrianglePipeline(2)) {
            pipeline.drawOn(7, nothing, VIEW, new Surface.Smooth(LIT), out, () -> false);
        }
        assertArrayEquals(new int[] {7, 7, 7, 7, 7, 7}, out.raster().argb());
    }

    @Test
    void aSecondMeshIsDrawnIntoTheFirstOnesDepth() {
        var out = new DepthRaster(WIDTH, HEIGHT);
        try (var pipeline = new TrianglePipeline(2)) {
            pipeline.drawOn(7, TORUS, VIEW, new Surface.Smooth(LIT), out, () -> false);
            int[] once = out.raster().argb().clone();
            pipeline.draw(TORUS, VIEW, new Surface.PerPixel(NORMALS), out, () -> false);
            assertArrayEquals(once, out.raster().argb());
        }
    }

    @Test
    @Tag("slow")
    void theLargestPictureIsDrawn() {
        var out = new DepthRaster(8192, 8192);
        float[] corners = {-1, -1, -1, 8192, 8192, 8192};
        var view = PixelSpace.view(8192, 8192, Culling.BACK);
        var mesh = PixelSpace.mesh(corners, 0, 1, 2);
        try (var pipeline = new TrianglePipeline(2)) {
            pipeline.drawOn(7, mesh, view, new Surface.Flat(VertexColors.own()), out, () -> false);
        }
        assertEquals(7, out.raster().argb(8190, 8190), "on the right edge");
        assertEquals(-1, out.raster().argb(8189, 8190));
        assertEquals(-1, out.raster().argb(0, 8191));
    }
}
