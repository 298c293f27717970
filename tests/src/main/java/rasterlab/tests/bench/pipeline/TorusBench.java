package rasterlab.tests.bench.pipeline;

import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.raster.Raster;

/**
 * A torus by the pipeline and by OpenGL: clear, light, texture, draw, finish. Nobody reads the
 * depths afterwards, and both are told so.
 */
final class TorusBench {
    private final InterleavedTimes.Length length;

    TorusBench(InterleavedTimes.Length length) {
        this.length = length;
    }

    Row run(TorusScene scene, TorusLook look, double goal, TrianglePipeline pipeline) {
        var mesh = scene.mesh();
        var view = scene.view();
        Surface surface = look.surface(scene);
        int back = TorusScene.BACKGROUND;
        var out = new Raster(scene.width(), scene.height());
        try (var torus = new GlTorus(scene, look, mesh)) {
            var times =
                    new InterleavedTimes(
                            length,
                            () -> pipeline.drawOn(back, mesh, view, surface, out, () -> false),
                            torus::draw);
            return new Row(
                    scene + ", " + look.text(),
                    times.text(0),
                    "OpenGL " + times.text(1),
                    times.ratio(1, 0),
                    goal,
                    Difference.of(out.argb(), torus.read())::text);
        }
    }
}
