package rasterlab.app.polygon;

import java.util.List;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.outcome.CutAnswer;
import rasterlab.app.polygon.outcome.InsideAnswer;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.PolygonResults;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.app.polygon.outcome.Runs;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;

/** The pictures of outcomes. */
record PolygonPictures(PolygonTopics topics, Texts texts) {
    /** A method beside the exact answer. */
    PlanePicture of(PolygonScene scene, MethodOutcome outcome, int step) {
        PolygonFigure figure = scene.figure();
        if (outcome.answer() instanceof InsideAnswer inside)
            return judged(scene, outcome.method(), inside, "", step);
        if (outcome.answer() instanceof CutAnswer cut)
            return new CutPicture(
                    (CutFigure) figure, outcome.method(), cut, List.of(), "", step, List.of());
        var pixels = (PixelAnswer) outcome.answer();
        return new PixelsPicture(
                figure,
                outcome.method(),
                pixels,
                new PixelsPicture.WrongPixels(pixels.missing(), pixels.extra(), ""),
                step);
    }

    /** Both methods in one picture, with where they differ. */
    PlanePicture difference(PolygonResults results, int step) {
        MethodOutcome first = results.outcome();
        MethodOutcome second = results.other().orElseThrow();
        PolygonFigure figure = results.scene().figure();
        if (first.answer() instanceof InsideAnswer inside)
            return judged(results.scene(), first.method(), inside, second.method(), step);
        if (first.answer() instanceof CutAnswer cut)
            return new CutPicture(
                    (CutFigure) figure,
                    first.method(),
                    cut,
                    ((CutAnswer) second.answer()).cuts(),
                    second.method(),
                    step,
                    List.of());
        var pixels = (PixelAnswer) first.answer();
        PixelDifference difference =
                PixelDifference.of(
                        recording(((PixelAnswer) second.answer()).runs()),
                        recording(pixels.runs()));
        return new PixelsPicture(
                figure,
                first.method(),
                pixels,
                new PixelsPicture.WrongPixels(
                        difference.missing(), difference.extra(), second.method()),
                step);
    }

    private InsidePicture judged(
            PolygonScene scene, String method, InsideAnswer answer, String other, int step) {
        return new InsidePicture(
                topics,
                scene.mode(),
                (InsideFigure) scene.figure(),
                method,
                answer,
                other,
                step,
                texts,
                List.of());
    }

    private static PixelRecording recording(Runs runs) {
        var recording = new PixelRecording(Integer.MAX_VALUE);
        for (int run = 0; run < runs.size(); run++)
            for (int x = runs.from(run); x < runs.to(run); x++) recording.plot(x, runs.y(run));
        return recording;
    }
}
