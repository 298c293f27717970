package rasterlab.app.coordinates.turn;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Ink;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.Spot;

/** The way round, and the chart of how far methods drift. */
final class TurnFigures {
    /** The decades of the chart: errors below are drawn there. */
    static final int LOWEST = -17;

    static final int HIGHEST = 1;
    private static final double BESIDE = 0.25;
    private static final double LABELS_APART = 0.95;

    /** So much error over the radius is seen. */
    private static final double SEEN = 0.005;

    /** Up to so many earlier places are drawn as dots. */
    private static final int DOTS = 80;

    private TurnFigures() {}

    static Figure way(TurnScene scene, int step) {
        var marks = new ArrayList<Mark>();
        if (scene.exact() == null) return new Figure(marks, true);
        marks.add(new Mark.Path(scene.circle(), Ink.HELP));
        var origin = new Spot(0, 0);
        Ink own = Ink.method(scene.choice().method());
        List<TurnScene.Step> done = scene.steps().subList(0, Math.min(step, scene.steps().size()));
        Spot start = new Spot(scene.choice().x(), scene.choice().y());
        marks.add(new Mark.Line(origin, start, Ink.GHOST));
        if (done.size() <= DOTS) {
            var path = new ArrayList<Spot>();
            path.add(start);
            done.forEach(each -> path.add(each.at()));
            marks.add(new Mark.Path(path, Ink.GHOST));
            for (TurnScene.Step each : done) marks.add(new Mark.Dot(each.at(), own, ""));
        } else {
            for (TurnScene.Step each : done) marks.add(new Mark.Dot(each.at(), own, ""));
        }
        if (step < scene.steps().size() || scene.steps().isEmpty()) {
            if (!done.isEmpty())
                marks.add(new Mark.Line(origin, done.get(done.size() - 1).at(), own));
            return new Figure(marks, true);
        }
        ends(scene, marks);
        return new Figure(marks, true);
    }

    /** Where the point ends, and where it belongs; other methods where that is seen. */
    private static void ends(TurnScene scene, List<Mark> marks) {
        for (TurnScene.Drift each : scene.drifts()) {
            boolean own = each.method().equals(scene.choice().method());
            if (each.refused() || !own && !(each.error() > SEEN)) continue;
            Ink ink = Ink.method(each.method());
            marks.add(new Mark.Line(new Spot(0, 0), each.end(), ink));
            marks.add(
                    new Mark.Dot(
                            each.end(), ink, own && each.error() <= SEEN ? "" : each.method()));
        }
        marks.add(new Mark.Cross(scene.exact(), Ink.OBJECT, ""));
    }

    static Figure chart(TurnScene scene, String turns, String error) {
        var marks = new ArrayList<Mark>();
        int right = (int) Math.round(Math.log10(TurnScene.CHARTED));
        for (int decade = LOWEST + 1; decade <= HIGHEST; decade += 2) {
            marks.add(new Mark.Line(new Spot(0, decade), new Spot(right, decade), Ink.HELP));
            marks.add(new Mark.Words(new Spot(-0.5, decade), Ink.OBJECT, "10" + raised(decade)));
        }
        for (int decade = 0; decade <= right; decade++) {
            marks.add(new Mark.Line(new Spot(decade, LOWEST), new Spot(decade, HIGHEST), Ink.HELP));
            marks.add(
                    new Mark.Words(
                            new Spot(decade, LOWEST - 0.7), Ink.OBJECT, "10" + raised(decade)));
        }
        marks.add(new Mark.Words(new Spot(right / 2.0, LOWEST - 1.7), Ink.OBJECT, turns));
        marks.add(new Mark.Words(new Spot(right / 2.0, HIGHEST + 0.8), Ink.OBJECT, error));
        curves(scene, marks);
        return new Figure(marks, false);
    }

    private static void curves(TurnScene scene, List<Mark> marks) {
        var ends = new ArrayList<Mark.Dot>();
        for (TurnScene.Drift each : scene.drifts()) {
            if (each.refused()) continue;
            var path = new ArrayList<Spot>();
            for (TurnScene.Sample sample : each.samples())
                path.add(new Spot(Math.log10(sample.times()), decade(sample.error())));
            Ink ink = Ink.method(each.method());
            marks.add(new Mark.Path(path, ink));
            path.forEach(spot -> marks.add(new Mark.Dot(spot, ink, "")));
            ends.add(new Mark.Dot(path.get(path.size() - 1), ink, each.method()));
        }
        label(ends, marks);
    }

    /** Names beside the curves' ends, from below, none over another. */
    private static void label(List<Mark.Dot> ends, List<Mark> marks) {
        double next = Double.NEGATIVE_INFINITY;
        ends.sort(Comparator.comparingDouble(end -> end.at().y()));
        for (Mark.Dot end : ends) {
            double y = Math.max(end.at().y(), next);
            marks.add(new Mark.Line(end.at(), new Spot(end.at().x() + BESIDE, y), end.ink()));
            marks.add(new Mark.Beside(new Spot(end.at().x() + BESIDE, y), end.ink(), end.label()));
            next = y + LABELS_APART;
        }
    }

    private static double decade(double error) {
        return error > 0 ? Math.max(LOWEST, Math.min(HIGHEST, Math.log10(error))) : LOWEST;
    }

    private static String raised(int number) {
        var raised = new StringBuilder();
        for (char each : String.valueOf(number).toCharArray())
            raised.append(each == '-' ? '⁻' : "⁰¹²³⁴⁵⁶⁷⁸⁹".charAt(each - '0'));
        return raised.toString();
    }
}
