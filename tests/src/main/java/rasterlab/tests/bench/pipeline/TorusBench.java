package rasterlab.tests.bench.pipeline;

import org.lwjgl.opengl.GL11C;
import rasterlab.engine.pipeline.triangle.DepthRaster;
import rasterlab.engine.pipeline.triangle.Surface;
import rasterlab.engine.pipeline.triangle.TrianglePipeline;
import rasterlab.engine.scene.VertexQuantity;

/** A torus by the pipeline and by OpenGL: clear, light, texture, draw, finish. */
final class TorusBench {
    private static final int ROUNDS = 40;

    private final int rounds;

    TorusBench(boolean quick) {
        rounds = quick ? ROUNDS / 4 : ROUNDS;
    }

    Row run(TorusScene scene, TorusLook look, double goal, TrianglePipeline pipeline) {
        var mesh = scene.mesh();
        var view = scene.view();
        var out = new DepthRaster(scene.width(), scene.height());
        Surface surface = look.surface(scene);
        try (var target = new GlTarget(scene.width(), scene.height());
                var program = look.program();
                var texture = look.texture();
                var glMesh = new GlMesh(mesh, VertexQuantity.NORMAL_X)) {
            program.use(scene.toEye(), scene.toClip());
            int back = TorusScene.BACKGROUND;
            var turns =
                    new Turns(
                            rounds,
                            () -> pipeline.drawOn(back, mesh, view, surface, out, () -> false),
                            () -> {
                                target.clear(back);
                                look.begin();
                                texture.bind();
                                glMesh.draw();
                                look.end();
                                GL11C.glFinish();
                            });
            return new Row(
                    scene + ", " + look.text(),
                    turns.text(0),
                    "OpenGL " + turns.text(1),
                    turns.ratio(1, 0),
                    goal,
                    Difference.of(out.raster().argb(), target.read()).text());
        }
    }
}
