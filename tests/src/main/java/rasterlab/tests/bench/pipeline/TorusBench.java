package rasterlab.tests.bench.pipeline;

import rasterlab.engine.pipeline.triangle.DepthRaster;
import rasterlab.engine.pipeline.triangle.Surface;
import rasterlab.engine.pipeline.triangle.TrianglePipeline;

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
        int back = TorusScene.BACKGROUND;
        try (var torus = new GlTorus(scene, look, mesh)) {
            var turns =
                    new Turns(
                            rounds,
                            () -> pipeline.drawOn(back, mesh, view, surface, out, () -> false),
                            torus::draw);
            return new Row(
                    scene + ", " + look.text(),
                    turns.text(0),
                    "OpenGL " + turns.text(1),
                    turns.ratio(1, 0),
                    goal,
                    Difference.of(out.raster().argb(), torus.read()).text());
        }
    }
}
