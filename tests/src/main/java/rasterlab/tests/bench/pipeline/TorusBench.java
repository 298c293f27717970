package rasterlab.tests.bench.pipeline;

import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;

/**
 * A torus by the call that draws a user's picture, and by OpenGL: clear, light, texture, draw,
 * finish. Both draw backs too, and OpenGL keeps all in its own memory, what is transparent in the
 * order of drawing.
 */
final class TorusBench {
    private final InterleavedTimes.Length length;

    TorusBench(InterleavedTimes.Length length) {
        this.length = length;
    }

    Row run(TorusScene scene, TorusLook look, double goal) {
        RenderRequest request = scene.request(look);
        var out = new Raster(scene.width(), scene.height());
        try (var renderer = new Renderer();
                var torus = new GlTorus(scene, look)) {
            var times =
                    new InterleavedTimes(
                            length, () -> renderer.render(request, out, () -> false), torus::draw);
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
