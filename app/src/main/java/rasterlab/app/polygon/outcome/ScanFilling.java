package rasterlab.app.polygon.outcome;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.polygon.scan.PolygonTask;
import rasterlab.engine.polygon.scan.RowCrossing;
import rasterlab.engine.polygon.scan.SpanWalk;
import rasterlab.engine.polygon.scan.SteppedPolygon;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Topic;

/** Fills a polygon by a method, span by span. */
final class ScanFilling {
    private ScanFilling() {}

    static MethodOutcome of(
            Topic<PolygonFiller, PolygonTask, PixelRecording> topic,
            FillFigure figure,
            String method) {
        PolygonTask task = figure.task();
        PixelRecording exact = topic.exact(task, topic.mostItems());
        var filled = new PixelRecording((int) topic.mostBeforeEndless(exact.size()));
        var runs = new Runs();
        Map<Integer, List<RowCrossing>> crossings = new HashMap<>();
        var attempt =
                new Attempt(
                        () -> {
                            PolygonFiller filler = topic.method(method).implementation();
                            if (filler instanceof SteppedPolygon stepped)
                                drain(stepped, task, filled, runs, crossings);
                            else take(filler, task, filled, runs);
                        });
        boolean refused = attempt.ending() == MethodOutcome.MethodEnding.REFUSED;
        PixelDifference difference = PixelDifference.of(refused ? filled : exact, filled);
        return new MethodOutcome(
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

    /** Takes an answer span by span; how many edges cross a row is not known. */
    private static void take(
            PolygonFiller filler, PolygonTask task, PixelRecording filled, Runs runs) {
        filler.fill(
                task.x(),
                task.y(),
                task.rule(),
                task.width(),
                task.height(),
                (y, from, to) -> {
                    runs.add(y, from, to, 0);
                    for (int x = from; x < to; x++) filled.plot(x, y);
                });
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
