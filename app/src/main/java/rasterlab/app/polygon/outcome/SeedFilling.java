package rasterlab.app.polygon.outcome;

import java.util.Map;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.fill.FillTask;
import rasterlab.engine.fill.TextPicture;
import rasterlab.engine.fill.TracedFill;
import rasterlab.engine.fill.WatchedPicture;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Topic;

/** Fills a region from a pixel by a method, run by run. */
final class SeedFilling {
    private SeedFilling() {}

    static MethodOutcome of(
            Topic<SeedFiller, FillTask, PixelRecording> topic, SeedFigure figure, String method) {
        FillTask task = figure.task();
        PixelRecording exact = topic.exact(task, topic.mostItems());
        var written = new PixelRecording((int) topic.mostBeforeEndless(exact.size()));
        var picture = new WatchedPicture(new TextPicture(task.rows()), written);
        var runs = new Runs();
        var attempt =
                new Attempt(
                        () -> {
                            SeedFiller filler = topic.method(method).implementation();
                            if (!(filler instanceof TracedFill fill)) take(filler, task, written);
                            else
                                fill.trace(
                                        picture,
                                        task.x(),
                                        task.y(),
                                        task.with(),
                                        task.connectivity(),
                                        runs::add);
                        });
        // A method without runs of its own is told pixel by pixel.
        if (runs.size() == 0)
            for (int i = 0; i < written.size(); i++)
                runs.add(written.y(i), written.x(i), written.x(i) + 1, 0);
        boolean refused = attempt.ending() == MethodOutcome.MethodEnding.REFUSED;
        PixelDifference difference = PixelDifference.of(refused ? written : exact, written);
        return new MethodOutcome(
                method,
                attempt.ending(),
                attempt.message(),
                topic.compare(task, refused ? written : exact, written),
                new PixelAnswer(
                        runs,
                        difference.missing(),
                        difference.extra(),
                        Map.of(),
                        picture.reads(),
                        written.size()));
    }

    /** Has a picture filled whose reads nobody counts. */
    private static void take(SeedFiller filler, FillTask task, PixelRecording written) {
        filler.fill(
                new WatchedPicture(new TextPicture(task.rows()), written),
                task.x(),
                task.y(),
                task.with(),
                task.connectivity());
    }
}
