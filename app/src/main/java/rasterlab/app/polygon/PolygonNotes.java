package rasterlab.app.polygon;

import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PixelAnswer;

/** One sentence over a stage where the picture alone would mislead. */
final class PolygonNotes {
    private PolygonNotes() {}

    /** "" where there is nothing to say. */
    static String about(PolygonFigure figure, MethodOutcome outcome, Texts texts) {
        String method = OwnWords.called(outcome.method(), texts.language());
        return switch (outcome.ending()) {
            case ENDLESS ->
                    texts.text("note.endless", method, ((PixelAnswer) outcome.answer()).writes());
            case REFUSED ->
                    OwnWords.refusal(outcome.method(), outcome.message(), texts.language())
                            .orElseGet(
                                    () ->
                                            texts.text(
                                                    "note.refused",
                                                    method,
                                                    reason(figure, outcome, texts)));
            case CRASHED -> crashed(outcome, texts);
            case ENDED -> ended(figure, outcome, texts);
        };
    }

    private static String crashed(MethodOutcome outcome, Texts texts) {
        if (outcome.message().contains("StackOverflowError"))
            return texts.text(
                    "note.overflow",
                    OwnWords.called(outcome.method(), texts.language()),
                    outcome.steps());
        return texts.text(
                "note.crashed",
                OwnWords.called(outcome.method(), texts.language()),
                outcome.message());
    }

    private static String ended(PolygonFigure figure, MethodOutcome outcome, Texts texts) {
        if (figure instanceof SeedFigure seed && seed.same())
            return texts.text("note.same", OwnWords.called(outcome.method(), texts.language()));
        if (outcome.isRight()) return "";
        if (figure instanceof CutFigure) {
            double percent = outcome.deviation().worst();
            return texts.text(
                    "note.cut",
                    OwnWords.called(outcome.method(), texts.language()),
                    Shown.number(percent, 1, texts.locale()));
        }
        return "";
    }

    /** Why a method refuses the figure, in the window's language. */
    static String reason(PolygonFigure figure, MethodOutcome outcome, Texts texts) {
        return texts.text("refusal." + reasonKey(figure, outcome));
    }

    private static String reasonKey(PolygonFigure figure, MethodOutcome outcome) {
        if (figure instanceof InsideFigure)
            return switch (outcome.method()) {
                case "sign-int" -> "whole";
                case "sign-float" -> "float";
                case "simplex" -> "area";
                default -> "range";
            };
        if (figure instanceof CutFigure)
            return outcome.method().equals("fan") ? "convex" : "simple";
        if (figure instanceof FillFigure) return "range";
        return ((SeedFigure) figure).connectivity() == 4
                        || ((SeedFigure) figure).connectivity() == 8
                ? "seed"
                : "connectivity";
    }
}
