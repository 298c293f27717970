package rasterlab.tests.bench.pipeline;

import org.lwjgl.opengl.GL11C;
import rasterlab.engine.pipeline.triangle.DepthRaster;
import rasterlab.engine.pipeline.triangle.Surface;
import rasterlab.engine.pipeline.triangle.TrianglePipeline;
import rasterlab.engine.scene.VertexQuantity;

/** A torus by the pipeline and by OpenGL: clear, light, draw, finish. */
final class TorusBench {
    private static final int ROUNDS = 40;

    private final int rounds;

    TorusBench(boolean quick) {
        rounds = quick ? ROUNDS / 4 : ROUNDS;
    }

    /**
     * @param perPixel light for each pixel rather than for each vertex
     */
    Row run(TorusScene scene, boolean perPixel, double goal, TrianglePipeline pipeline) {
        var mesh = scene.mesh();
        var view = scene.view();
        var out = new DepthRaster(scene.width(), scene.height());
        Surface surface =
                perPixel ? new Surface.PerPixel(scene.light()) : new Surface.Smooth(scene.light());
        try (var target = new GlTarget(scene.width(), scene.height());
                var program = perPixel ? GlProgram.phong() : GlProgram.smooth();
                var glMesh = new GlMesh(mesh, VertexQuantity.NORMAL_X)) {
            GL11C.glEnable(GL11C.GL_CULL_FACE);
            program.use(scene.toEye(), scene.toClip());
            var turns =
                    new Turns(
                            rounds,
                            () ->
                                    pipeline.drawOn(
                                            TorusScene.BACKGROUND,
                                            mesh,
                                            view,
                                            surface,
                                            out,
                                            () -> false),
                            () -> {
                                target.clear(TorusScene.BACKGROUND);
                                glMesh.draw();
                                GL11C.glFinish();
                            });
            var difference = Difference.of(out.raster().argb(), target.read());
            return new Row(
                    scene + (perPixel ? ", Phong" : ", Gouraud"),
                    turns.text(0),
                    "OpenGL " + turns.text(1),
                    turns.ratio(1, 0),
                    goal,
                    difference.text());
        }
    }
}
