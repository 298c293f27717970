package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.Set;
import org.joml.Matrix4d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.transform.GlMatrices;

/** Triangles that cross each other and every plane of the view, against {@link ExactPixel}. */
class ExactPictureTest {
    private static final int SCENES = Boolean.getBoolean("rasterlab.full") ? 400 : 25;
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;

    /** Four ulps below 1: of the vertices' depth, of the plane's, of the row's, of the pixel's. */
    private static final double DEPTH_BOUND = 4 * Math.ulp(0.5f);

    private static final Matrix4d TO_EYE = new Matrix4d().translate(0, 0, -4).rotateY(0.4);
    private static final Matrix4d TO_CLIP = GlMatrices.perspective(50, 4.0 / 3, 1, 9);

    private static TrianglePipeline pipeline;

    @BeforeAll
    static void start() {
        pipeline = new TrianglePipeline(2);
    }

    @AfterAll
    static void stop() {
        pipeline.close();
    }

    @Test
    void colorsAreWithinOneLevelAndDepthsWithinTheirBound() {
        compare(new Surface.Smooth(VertexColors.own()));
    }

    @Test
    void pixelsByBatchesAreTheSame() {
        compare(new Surface.PerPixel(new OwnColors()));
    }

    private static void compare(Surface surface) {
        int sure = 0;
        for (int seed = 0; seed < SCENES; seed++) {
            var mesh = scene(new Random(seed));
            var out = new DepthRaster(WIDTH, HEIGHT);
            var view = new TriangleView(TO_EYE, TO_CLIP, List.of(), Culling.NONE);
            pipeline.drawOn(0xFF000000, mesh, view, surface, out, () -> false);
            sure += comparePixels(mesh, out, "seed " + seed);
        }
        int pixels = SCENES * WIDTH * HEIGHT;
        assertTrue(sure > 0.8 * pixels, "only " + sure + " of " + pixels + " could be compared");
    }

    private static int comparePixels(TriangleMesh mesh, DepthRaster out, String scene) {
        var exact = new ExactPixel(mesh, new Matrix4d(TO_CLIP).mul(TO_EYE).get(new double[16]));
        int sure = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int x = i % WIDTH;
            int y = i / WIDTH;
            exact.look((x + 0.5) * 2 / WIDTH - 1, 1 - (y + 0.5) * 2 / HEIGHT, 0.02 / WIDTH);
            if (exact.doubtful) continue;
            sure++;
            String place = "%s, pixel (%d, %d)".formatted(scene, x, y);
            assertEquals(exact.depth, out.depth()[i], exact.slack + DEPTH_BOUND, place);
            if (exact.depth == 1) continue;
            for (int c = 0; c < 3; c++)
                assertEquals(
                        exact.rgb[c],
                        out.raster().argb()[i] >> 16 - 8 * c & 255,
                        1.0,
                        place + ", channel " + c);
        }
        return sure;
    }

    private static TriangleMesh scene(Random random) {
        int count = 24;
        float[][] place = new float[3][count];
        float[][] color = new float[4][count];
        int[] triangles = new int[count];
        for (int v = 0; v < count; v++) {
            triangles[v] = v;
            for (float[] axis : place) axis[v] = 6 * random.nextFloat() - 3;
            for (float[] channel : color) channel[v] = random.nextFloat();
        }
        return TriangleMesh.of(place[0], place[1], place[2], triangles)
                .withColors(color[0], color[1], color[2], color[3]);
    }

    /** Colours of the vertices, rounded by the surface itself. */
    private static final class OwnColors implements PixelColors {
        @Override
        public Set<VertexQuantity> wants() {
            return Set.of(VertexQuantity.RED, VertexQuantity.GREEN, VertexQuantity.BLUE);
        }

        @Override
        public void color(PixelBatch batch) {
            float[] red = batch.values(VertexQuantity.RED);
            float[] green = batch.values(VertexQuantity.GREEN);
            float[] blue = batch.values(VertexQuantity.BLUE);
            for (int i = 0; i < batch.count; i++)
                batch.argb[i] =
                        0xFF000000
                                | Math.round(255 * red[i]) << 16
                                | Math.round(255 * green[i]) << 8
                                | Math.round(255 * blue[i]);
        }
    }
}
