package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.List;
import java.util.Random;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.surface.ColoredPixels;
import rasterlab.engine.pipeline.surface.TexelFilter;
import rasterlab.engine.pipeline.surface.TexturedPixels;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.shape.TriangleGrid;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.GlMatrices;

/** The picture of several threads beside that of one, bit for bit. */
@Tag("slow")
class ThreadsPictureTest {
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
                    textured(TexelFilter.NEAREST),
                    textured(TexelFilter.LINEAR),
                    textured(TexelFilter.MIPMAP));

    private static Surface textured(TexelFilter filter) {
        int[] argb = new Random(1983).ints(64 * 32).toArray();
        var texture = Texture.of(64, 32, 4, argb);
        var sampler = new TextureSampler(texture, Wrap.REPEAT, Wrap.REPEAT);
        var mode = TextureEnvironment.of(TextureEnvironment.Mode.MODULATE, texture);
        return new Surface.PerPixel(new TexturedPixels(sampler, filter, mode, new ColoredPixels()));
    }

    /**
     * Pictures as wide as one pixel to more than a batch, triangles from specks to slivers; with
     * depths that are kept and without.
     */
    @ParameterizedTest(name = "with {0} threads a bit of a picture is another")
    @ValueSource(ints = {2, 3})
    void drawTheSamePicture(int threads) {
        long seed = 2026 + threads;
        var random = new Random(seed);
        try (var one = new TrianglePipeline(1);
                var several = new TrianglePipeline(threads)) {
            for (int k = 0; k < PICTURES; k++) {
                int width = 1 + random.nextInt(k % 4 == 0 ? 1500 : 70);
                int height = 1 + random.nextInt(100);
                var mesh = mesh(random, width, height, TRIANGLES, 3 * width + 50);
                var view = PixelSpace.view(width, height, Culling.NONE);
                String what = "seed %d, picture %d".formatted(seed, k);
                drawBoth(new Scene(what, width, height, view, mesh), one, several);
            }
        }
    }

    /** The mesh has as many triangles as pixels, so that small ones are found in blocks. */
    @ParameterizedTest(name = "with {0} threads a bit of a crowded picture is another")
    @ValueSource(ints = {2, 3})
    void drawTheSameCrowdedPicture(int threads) {
        long seed = 2036 + threads;
        var random = new Random(seed);
        try (var one = new TrianglePipeline(1);
                var several = new TrianglePipeline(threads)) {
            for (int k = 0; k < PICTURES / 4; k++) {
                int width = 1 + random.nextInt(70);
                int height = 1 + random.nextInt(100);
                int size = random.nextBoolean() ? 4 : 40;
                var mesh = mesh(random, width, height, width * height, size);
                var view = PixelSpace.view(width, height, Culling.NONE);
                String what = "seed %d, picture %d".formatted(seed, k);
                drawBoth(new Scene(what, width, height, view, mesh), one, several);
            }
        }
    }

    /** Where corners are not all as far from the eye, and some behind it. */
    @ParameterizedTest(name = "with {0} threads a bit of a crowded torus is another")
    @ValueSource(ints = {2, 3})
    void drawTheSameCrowdedTorus(int threads) {
        var toEye = new Matrix4d().translate(0, 0.2, -1.2).rotateX(-0.9);
        var view = new TriangleView(toEye, GlMatrices.perspective(60, 1.25, 0.1, 10));
        var torus = TriangleGrid.torus(200, 100);
        float[][] color = new float[4][torus.vertexCount()];
        var random = new Random(2046);
        for (float[] channel : color)
            for (int v = 0; v < channel.length; v++) channel[v] = random.nextFloat();
        var mesh = torus.withColors(color[0], color[1], color[2], color[3]);
        try (var one = new TrianglePipeline(1);
                var several = new TrianglePipeline(threads)) {
            drawBoth(new Scene("torus", 100, 80, view, mesh), one, several);
        }
    }

    private record Scene(String what, int width, int height, TriangleView view, TriangleMesh mesh) {
        DepthRaster picture() {
            return new DepthRaster(width, height);
        }
    }

    private static void drawBoth(Scene scene, TrianglePipeline one, TrianglePipeline several) {
        for (Surface surface : SURFACES) {
            DepthRaster expected = scene.picture();
            DepthRaster actual = scene.picture();
            one.drawOn(7, scene.mesh, scene.view, surface, expected, () -> false);
            several.drawOn(7, scene.mesh, scene.view, surface, actual, () -> false);
            String what = scene.what + ", " + surface;
            SamePicture.assertSame(expected, actual, what);
            for (var pipeline : List.of(one, several)) {
                var alone = new Raster(scene.width, scene.height);
                pipeline.drawOn(7, scene.mesh, scene.view, surface, alone, () -> false);
                assertArrayEquals(expected.raster().argb(), alone.argb(), what);
            }
        }
    }

    /**
     * Some corners on whole pixels, some triangles beyond the picture.
     *
     * @param size up to how many pixels a triangle's box has along a side
     */
    private static TriangleMesh mesh(Random random, int width, int height, int count, int size) {
        float[] corners = new float[6 * count];
        float[] depth = new float[3 * count];
        float[][] color = new float[4][3 * count];
        float[][] st = new float[2][3 * count];
        int[] triangles = new int[3 * count];
        for (int t = 0; t < count; t++) {
            float reach = (float) Math.exp(random.nextDouble() * Math.log(size));
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
}
