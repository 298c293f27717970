package rasterlab.tests.bench.pipeline;

import java.util.Random;
import org.joml.Matrix4d;
import org.lwjgl.opengl.GL11C;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/** Triangles in boxes of one size anywhere in the picture, at any depth, with coloured corners. */
final class FillBench {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;

    /** All boxes together, in pixels: about seven pictures. */
    private static final int AREA = 6_000_000;

    private final InterleavedTimes.Length length;

    FillBench(InterleavedTimes.Length length) {
        this.length = length;
    }

    Row run(int side, double goal, TrianglePipeline pipeline) {
        var mesh = mesh(side, AREA / (side * side));
        var toEye = new Matrix4d();
        var toClip = new Matrix4d();
        var view = new TriangleView(toEye, toClip);
        var surface = new Surface.Smooth(VertexColors.own());
        var out = new Raster(WIDTH, HEIGHT);
        try (var target = new GlTarget(WIDTH, HEIGHT);
                var program = GlProgram.colored();
                var glMesh = new GlMesh(mesh, VertexQuantity.RED)) {
            GL11C.glEnable(GL11C.GL_CULL_FACE);
            program.use(toEye, toClip);
            var times =
                    new InterleavedTimes(
                            length,
                            () -> pipeline.drawOn(0, mesh, view, surface, out, () -> false),
                            () -> {
                                target.clear(0xFF000000);
                                glMesh.draw();
                                target.forgetDepths();
                                GL11C.glFinish();
                            });
            return new Row(
                    "%,d triangles of %d px with depth".formatted(mesh.triangleCount(), side),
                    times.text(0),
                    "OpenGL " + times.text(1),
                    times.ratio(1, 0),
                    goal,
                    Difference.of(out.argb(), target.read())::text);
        }
    }

    /** Corners of the boxes' sides in −1..1, so turned that none is culled. */
    private static TriangleMesh mesh(int side, int count) {
        var random = new Random(1974);
        float[][] place = new float[3][3 * count];
        float[][] color = new float[4][3 * count];
        int[] triangles = new int[3 * count];
        for (int t = 0; t < count; t++) {
            double left = random.nextDouble() * (WIDTH - side);
            double bottom = random.nextDouble() * (HEIGHT - side);
            float depth = random.nextFloat() * 1.8f - 0.9f;
            for (int k = 0; k < 3; k++) {
                int v = 3 * t + k;
                triangles[v] = v;
                place[0][v] = (float) ((left + random.nextDouble() * side) * 2 / WIDTH - 1);
                place[1][v] = (float) ((bottom + random.nextDouble() * side) * 2 / HEIGHT - 1);
                place[2][v] = depth + random.nextFloat() * 0.1f;
                for (float[] channel : color) channel[v] = random.nextFloat();
            }
            if (turnsClockwise(place, 3 * t)) triangles[3 * t + 1] = 3 * t + 2;
            if (turnsClockwise(place, 3 * t)) triangles[3 * t + 2] = 3 * t + 1;
        }
        return TriangleMesh.of(place[0], place[1], place[2], triangles)
                .withColors(color[0], color[1], color[2], color[3]);
    }

    private static boolean turnsClockwise(float[][] p, int a) {
        return (p[0][a + 1] - p[0][a]) * (p[1][a + 2] - p[1][a])
                < (p[1][a + 1] - p[1][a]) * (p[0][a + 2] - p[0][a]);
    }
}
