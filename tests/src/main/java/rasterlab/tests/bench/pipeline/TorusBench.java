package rasterlab.tests.bench.pipeline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.pipeline.fast.Surface;
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

    /** One row for each way, the goal in the first one's. */
    List<Row> run(TorusScene scene, TorusLook look, double goal, List<Way> ways) {
        var mesh = scene.mesh();
        var view = scene.view();
        Surface surface = look.surface(scene);
        int back = TorusScene.BACKGROUND;
        var pictures = new ArrayList<Raster>();
        var runs = new ArrayList<Runnable>();
        for (Way way : ways) {
            var out = new Raster(scene.width(), scene.height());
            pictures.add(out);
            runs.add(() -> way.pipeline().drawOn(back, mesh, view, surface, out, () -> false));
        }
        try (var torus = new GlTorus(scene, look, mesh)) {
            runs.add(torus::draw);
            var times = new InterleavedTimes(length, runs.toArray(Runnable[]::new));
            int[] peer = torus.read();
            var rows = new ArrayList<Row>();
            for (int k = 0; k < ways.size(); k++)
                rows.add(
                        new Row(
                                "%s, %s, %s".formatted(scene, look.text(), ways.get(k).name()),
                                times.text(k),
                                "OpenGL " + times.text(ways.size()),
                                times.ratio(ways.size(), k),
                                k == 0 ? goal : 0,
                                Difference.of(pictures.get(k).argb(), peer)::text));
            return rows;
        }
    }
}
