package rasterlab.app.coordinates.meeting;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.engine.geometry.Line;

/** The plane as its edge, the line, and where they meet. */
final class MeetingFigure {
    private static final double NORMAL = 0.4;

    /** The distance from the plane down to the middle of its name. */
    private static final double NAME = 0.07;

    /** The length of the line drawn behind p₁ and beyond p₂, in units. */
    private static final double BEYOND = 0.4;

    private final MeetingScene scene;
    private final SideView view;
    private final List<Mark> marks = new ArrayList<>();

    private MeetingFigure(MeetingScene scene, SideView view) {
        this.scene = scene;
        this.view = view;
    }

    static Figure of(MeetingScene scene, SideView view) {
        var figure = new MeetingFigure(scene, view);
        figure.line();
        if (view.reached()) figure.plane();
        figure.meetings();
        return new Figure(figure.marks, true);
    }

    /** Whether the point that belongs to μ is near enough to be drawn. */
    static boolean drawn(double mu) {
        return Math.abs(mu) <= SideView.FARTHEST;
    }

    private StagePoint at(double mu) {
        Line line = scene.choice().line();
        StagePoint from = view.spot(line.from());
        StagePoint through = view.spot(line.through());
        return new StagePoint(
                from.x() + mu * (through.x() - from.x()), from.y() + mu * (through.y() - from.y()));
    }

    private void line() {
        double reach = drawn(scene.exact()) ? scene.exact() : 0;
        double least = Math.min(0, reach) - BEYOND;
        double most = Math.max(1, reach) + BEYOND;
        marks.add(new Mark.LineMark(at(least), at(most), MarkInk.HELP));
        marks.add(new Mark.ArrowMark(at(0), at(1), MarkInk.OBJECT, ""));
    }

    private void plane() {
        double least = Math.min(at(0).x(), at(1).x()) - BEYOND;
        double most = Math.max(at(0).x(), at(1).x()) + BEYOND;
        if (drawn(scene.exact())) {
            least = Math.min(least, at(scene.exact()).x() - BEYOND);
            most = Math.max(most, at(scene.exact()).x() + BEYOND);
        }
        marks.add(
                new Mark.LineMark(new StagePoint(least, 0), new StagePoint(most, 0), MarkInk.EDGE));
        marks.add(
                new Mark.ArrowMark(
                        new StagePoint(least, 0),
                        new StagePoint(least, NORMAL),
                        MarkInk.axis(2),
                        "n"));
        marks.add(new Mark.WordsMark(new StagePoint(most, -NAME), MarkInk.EDGE, "n·p = c"));
    }

    /** Draws the right place as a cross, the chosen method's as a dot of its colour. */
    private void meetings() {
        if (drawn(scene.exact()))
            marks.add(new Mark.CrossMark(at(scene.exact()), MarkInk.OBJECT, ""));
        MeetingScene.MeetingAnswer chosen = scene.chosen();
        if (Double.isFinite(chosen.mu()) && drawn(chosen.mu()))
            marks.add(new Mark.DotMark(at(chosen.mu()), MarkInk.method(chosen.method()), "μ"));
    }
}
