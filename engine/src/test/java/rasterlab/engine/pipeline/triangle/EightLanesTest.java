package rasterlab.engine.pipeline.triangle;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;
import rasterlab.engine.pipeline.surface.ColoredPixels;
import rasterlab.engine.pipeline.surface.TextureFilter;
import rasterlab.engine.pipeline.surface.TexturedPixels;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/** The picture of eight lanes beside that of one, bit for bit. */
class EightLanesTest {
    private static final int PICTURES = 60;
    private static final int TRIANGLES = 60;

    private static final List<Surface> SURFACES =
            List.of(
                    new Surface.Smooth(VertexColors.own()),
                    new Surface.Flat(VertexColors.own()),
                    new Surface.PerPixel(new ColoredPixels()),
                    new Surface.PerPixel(new ColoredPixels()).with(Blending.GLASS),
                    new Surface.PerPixel(new ColoredPixels())
                            .over(new Surface.Flat(VertexColors.own()))
                            .with(Blending.OVER.dropBelow(90)),
                    new Surface.PerPixel(new ColoredPixels()).with(Blending.OVER.withoutDepth()),
                    textured(TextureFilter.NEAREST),
                    textured(TextureFilter.LINEAR),
                    textured(TextureFilter.MIPMAP));

    private static Surface textured(TextureFilter filter) {
        int[] argb = new Random(1983).ints(64 * 32).toArray();
        var texture = Texture.of(64, 32, 4, argb);
        var sampler = new TextureSampler(texture, Wrap.REPEAT, Wrap.REPEAT);
        var mode = TextureEnvironment.of(TextureEnvironment.Mode.MODULATE, texture);
        return new Surface.PerPixel(new TexturedPixels(sampler, filter, mode, new ColoredPixels()));
    }

    @BeforeAll
    static void needEight() {
        EightLanes.assumeThere();
    }

    /**
     * Pictures as wide as one pixel to more than a batch, triangles from specks to slivers; with
     * depths that are kept and without.
     */
    @ParameterizedTest(name = "with {0} threads a bit of a picture is another")
    @ValueSource(ints = {1, 2, 3})
    void drawTheSamePicture(int threads) {
        long seed = 2026 + threads;
        var random = new Random(seed);
        try (var one = new TrianglePipeline(1, Lanes.ONE);
                var eight = new TrianglePipeline(threads, Lanes.EIGHT)) {
            for (int k = 0; k < PICTURES; k++) {
                int width = 1 + random.nextInt(k % 4 == 0 ? 1500 : 70);
                int height = 1 + random.nextInt(100);
                var view = PixelSpace.view(width, height, Culling.NONE);
                var mesh = mesh(random, width, height);
                for (Surface surface : SURFACES) {
                    var expected = new DepthRaster(width, height);
                    var actual = new DepthRaster(width, height);
                    one.drawOn(7, mesh, view, surface, expected, () -> false);
                    eight.drawOn(7, mesh, view, surface, actual, () -> false);
                    String what = "seed %d, picture %d, %s".formatted(seed, k, surface);
                    EightLanes.assertSame(expected, actual, what);
                    for (var pipeline : List.of(one, eight)) {
                        var alone = new Raster(width, height);
                        pipeline.drawOn(7, mesh, view, surface, alone, () -> false);
                        assertArrayEquals(expected.raster().argb(), alone.argb(), what);
                    }
                }
            }
        }
    }

    /** Some corners on whole pixels, some triangles far beyond the picture. */
    private static TriangleMesh mesh(Random random, int width, int height) {
        float[] corners = new float[6 * TRIANGLES];
        float[] depth = new float[3 * TRIANGLES];
        float[][] color = new float[4][3 * TRIANGLES];
        float[][] st = new float[2][3 * TRIANGLES];
        int[] triangles = new int[3 * TRIANGLES];
        for (int t = 0; t < TRIANGLES; t++) {
            float reach = (float) Math.exp(random.nextDouble() * Math.log(3 * width + 50));
            float x = random.nextFloat() * (width + reach) - reach;
            float y = random.nextFloat() * (height + reach) - reach;
            boolean whole = random.nextInt(4) == 0;
            for (int v = 3 * t; v < 3 * t + 3; v++) {
                float right = x + random.nextFloat() * reach;
                float down = y + random.nextFloat() * reach;
                corners[2 * v] = whole ? Math.round(right) : right;
                corners[2 * v + 1] = whole ? Math.round(down) : down;
                depth[v] = 0.05f + random.nextFloat() * 0.9f;
                triangles[v] = v;
                for (float[] channel : color) channel[v] = random.nextFloat();
                for (float[] axis : st) axis[v] = 6 * random.nextFloat() - 3;
            }
        }
        return PixelSpace.mesh(corners, depth, triangles)
                .withColors(color[0], color[1], color[2], color[3])
                .withTexture(st[0], st[1]);
    }

    /** What is written back there may be stale: the next band is another thread's. */
    @ParameterizedTest(name = "the band from row {0} reaches into row {1}")
    @CsvSource({"0, 32", "32, 64", "64, 70"})
    void stayInTheirBand(int top, int end) {
        var out = new DepthRaster(5, 70);
        var vertices = new ScreenVertices();
        vertices.begin(3, 0);
        vertices.put(1, 4 * Subpixels.ONE, 0, 0, 0);
        vertices.put(2, 0, 80 * Subpixels.ONE, 0, 0);
        var scan = new TriangleScan();
        scan.load(vertices, 0, 1, 2, Bands.of(out, top));
        assertEquals(end * 5, scan.end);
    }

    @Test
    void chooseEightWhereTheyAre() {
        assertTrue(Lanes.best() == Lanes.EIGHT, "one lane was chosen");
    }
}
