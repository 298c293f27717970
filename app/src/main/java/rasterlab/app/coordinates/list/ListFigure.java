package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.coordinates.figure.Wireframe;

/** The figure that the stage shows after some steps of a list. */
final class ListFigure {
    /** An axis is so many times as long as the subject reaches. */
    private static final double LONGER = 1.3;

    private static final String[] MOVED = {"x′", "y′", "z′"};

    private final ListScene scene;
    private final int dimension;
    private final ListPlaces places;
    private final List<Mark> marks = new ArrayList<>();

    private ListFigure(ListScene scene) {
        this.scene = scene;
        dimension = scene.choice().dimension();
        places = new ListPlaces(scene.choice());
    }

    static Figure of(ListScene scene, int step) {
        var figure = new ListFigure(scene);
        if (dimensionOf(scene) == 3) figure.marks.addAll(figure.places.axes(figure.reach()));
        if (!scene.isRefused()) figure.draw(step);
        else figure.wire(scene.choice().wire().numbers(), MarkInk.OBJECT);
        return new Figure(figure.marks, dimensionOf(scene) == 2);
    }

    private static int dimensionOf(ListScene scene) {
        return scene.choice().dimension();
    }

    private void draw(int step) {
        for (int earlier = 0; earlier < step; earlier++)
            wire(scene.images(earlier, false), MarkInk.GHOST);
        if (scene.wrong()) wire(scene.images(step, true), MarkInk.OBJECT);
        wire(
                scene.images(step, false),
                scene.wrong() ? MarkInk.PRINTED : MarkInk.OBJECT,
                scene.h(step));
        if (scene.choice().reading() == Reading.FRAME) frame(step);
    }

    private void wire(double[] points, MarkInk ink) {
        wire(points, ink, new double[0]);
    }

    /**
     * @param h of each point; an edge to one with H ≤ 0 is drawn wrong. None where all are before
     *     the eye
     */
    private void wire(double[] points, MarkInk ink, double[] h) {
        List<StagePoint> spots = places.of(points);
        if (scene.choice().subject().wire().edges().isEmpty()) dots(spots, ink, h);
        for (Wireframe.Edge edge : scene.choice().subject().wire().edges()) {
            boolean right = h.length == 0 || h[edge.from()] > 0 && h[edge.to()] > 0;
            marks.add(
                    new Mark.LineMark(
                            spots.get(edge.from()),
                            spots.get(edge.to()),
                            right ? ink : MarkInk.WRONG));
        }
    }

    private void dots(List<StagePoint> spots, MarkInk ink, double[] h) {
        for (int i = 0; i < spots.size(); i++)
            marks.add(
                    new Mark.DotMark(
                            spots.get(i), h.length == 0 || h[i] > 0 ? ink : MarkInk.WRONG, ""));
    }

    /** The largest coordinate of the subject, as far as it reaches. */
    private double reach() {
        return scene.choice().points().stream().mapToDouble(Math::abs).max().orElse(1);
    }

    /** Draws the axes that the steps have moved. */
    private void frame(int step) {
        List<StagePoint> ends = places.of(scene.frame(step, LONGER * reach()));
        for (int axis = 0; axis < dimension; axis++)
            marks.add(
                    new Mark.ArrowMark(
                            ends.get(0), ends.get(axis + 1), MarkInk.axis(axis), MOVED[axis]));
    }
}
