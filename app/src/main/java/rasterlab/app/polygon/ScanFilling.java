package rasterlab.app.polygon;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.scan.PolygonTask;
import rasterlab.engine.polygon.scan.RowCrossing;
import rasterlab.engine.polygon.scan.SpanWalk;
import rasterlab.engine.polygon.scan.SteppedPolygon;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;

/** Fills a polygon by a method, span by span. */
final class ScanFilling {
    private ScanFilling() {}

    static Outcome of(PolygonFillTopic topic, FillFigure figure, String method) {
        PolygonTask task = figure.task();
        PixelRecording exact = topic.exact(task, topic.mostItems());
        var filled = new PixelRecording((int) topic.mostBeforeEndless(exact.size()));
        var runs = new Runs();
        Map<Integer, List<RowCrossing>> crossings = new HashMap<>();
        var attempt =
                new Attempt(
                        () -> {
                            if (topic.method(method).implementation()
                                    instanceof SteppedPolygon stepped)
                                drain(stepped, task, filled, runs, crossings);
                        });
        boolean refused = attempt.ending() == Outcome.Ending.REFUSED;
        PixelDifference difference = PixelDifference.of(refused ? filled : exact, filled);
        return new Outcome(
                method,
                attempt.ending(),
                attempt.message(),
                topic.compare(task, refused ? filled : exact, filled),
                new PixelAnswer(
                        runs,
                        difference.missing(),
                        difference.extra(),
                        crossings,
                        0,
                        filled.size()));
    }

    private static void drain(
            SteppedPolygon stepped,
            PolygonTask task,
            PixelRecording filled,
            Runs runs,
            Map<Integer, List<RowCrossing>> crossings) {
        SpanWalk walk = stepped.walk(task.x(), task.y(), task.rule(), task.width(), task.height());
        while (walk.advance()) {
            runs.add(walk.y(), walk.from(), walk.to(), walk.crossings());
            crossings.computeIfAbsent(walk.y(), row -> walk.row());
            for (int x = walk.from(); x < walk.to(); x++) filled.plot(x, walk.y());
        }
    }
}
