package rasterlab.app.coordinates.turn;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.language.Language;

/** The way round. */
final class TurnFigure {
    /** The error over the radius from which on it is seen. */
    private static final double SEEN = 0.005;

    /** The number of earlier places up to which they are drawn as dots. */
    private static final int DOTS = 80;

    private TurnFigure() {}

    static Figure of(TurnScene scene, int step, Language language) {
        var marks = new ArrayList<Mark>();
        if (!scene.known()) return new Figure(marks, true);
        marks.add(new Mark.PathMark(scene.circle(), MarkInk.HELP));
        var origin = new StagePoint(0, 0);
        MarkInk own = MarkInk.method(scene.choice().method());
        List<TurnScene.TurnStep> done =
                scene.steps().subList(0, Math.min(step, scene.steps().size()));
        StagePoint start = new StagePoint(scene.choice().x(), scene.choice().y());
        marks.add(new Mark.LineMark(origin, start, MarkInk.GHOST));
        if (done.size() <= DOTS) {
            var path = new ArrayList<StagePoint>();
            path.add(start);
            done.forEach(each -> path.add(each.at()));
            marks.add(new Mark.PathMark(path, MarkInk.GHOST));
            for (TurnScene.TurnStep each : done) marks.add(new Mark.DotMark(each.at(), own, ""));
        } else {
            for (TurnScene.TurnStep each : done) marks.add(new Mark.DotMark(each.at(), own, ""));
        }
        if (step < scene.steps().size() || scene.steps().isEmpty()) {
            if (!done.isEmpty())
                marks.add(new Mark.LineMark(origin, done.get(done.size() - 1).at(), own));
            return new Figure(marks, true);
        }
        ends(scene, marks, language);
        return new Figure(marks, true);
    }

    /** Draws where the point ends, and where it belongs; other methods where that is seen. */
    private static void ends(TurnScene scene, List<Mark> marks, Language language) {
        for (TurnScene.Drift each : scene.drifts()) {
            boolean own = each.method().equals(scene.choice().method());
            if (each.refused() || !own && !(each.error() > SEEN)) continue;
            MarkInk ink = MarkInk.method(each.method());
            marks.add(new Mark.LineMark(new StagePoint(0, 0), each.end(), ink));
            marks.add(
                    new Mark.DotMark(
                            each.end(),
                            ink,
                            own && each.error() <= SEEN
                                    ? ""
                                    : OwnWords.called(each.method(), language)));
        }
        marks.add(new Mark.CrossMark(scene.exact(), MarkInk.OBJECT, ""));
    }
}
