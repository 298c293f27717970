package rasterlab.app.polygon;

import java.util.Map;
import rasterlab.engine.fill.FillTask;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.fill.TextPicture;
import rasterlab.engine.fill.TracedFill;
import rasterlab.engine.fill.WatchedPicture;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;

/** Fills a region from a pixel by a method, run by run. */
final class SeedFilling {
    private SeedFilling() {}

    static Outcome of(FillTopic topic, SeedFigure figure, String method) {
        FillTask task = figure.task();
        PixelRecording exact = topic.exact(task, topic.mostItems());
        var written = new PixelRecording((int) topic.mostBeforeEndless(exact.size()));
        var picture = new WatchedPicture(new TextPicture(task.rows()), written);
        var runs = new Runs();
        var attempt =
                new Attempt(
                        () -> {
                            if (topic.method(method).implementation() instanceof TracedFill fill)
                                fill.trace(
                                        picture,
                                        task.x(),
                                        task.y(),
                                        task.with(),
                                        task.connectivity(),
                                        runs::add);
                        });
        boolean refused = attempt.ending() == Outcome.Ending.REFUSED;
        PixelDifference difference = PixelDifference.of(refused ? written : exact, written);
        return new Outcome(
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
                        picture.writes()));
    }
}
