package rasterlab.app.polygon;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.List;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.polygon.CutAnswer.Cut;
import rasterlab.app.polygon.CutAnswer.Fault;
import rasterlab.engine.raster.PixelMark;

/**
 * A polygon and the triangles that a method has cut off it.
 *
 * @param other cuts of a second method whose diagonals are compared; none where it has a picture of
 *     its own
 * @param otherMethod its name, "" for none
 * @param step as {@link PolygonLabState#step}
 */
record CutPicture(
        CutFigure figure,
        String method,
        CutAnswer answer,
        List<Cut> other,
        String otherMethod,
        int step)
        implements PlanePicture {
    private static final double MARK = 20;

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColours colours, BooleanSupplier cancelled) {
        var strokes = new Strokes(g, map, colours);
        List<Cut> made = answer.cuts().subList(0, Math.min(step, answer.steps()));
        strokes.area(figure.corners(), colours.axis(), 40);
        Color colour = MethodColours.of(method);
        boolean stepping = step > 0 && step <= answer.steps();
        for (int i = 0; i < made.size(); i++) {
            boolean now = stepping && i == made.size() - 1;
            strokes.area(corners(made.get(i)), now ? colours.focus() : colour, now ? 110 : 70);
        }
        for (Cut cut : made) strokes.outline(corners(cut), edge(colours, colour), 1.8f);
        for (Cut cut : other)
            strokes.dashed(
                    figure.corners().get(cut.a()),
                    figure.corners().get(cut.c()),
                    edge(colours, MethodColours.of(otherMethod)));
        strokes.outline(figure.corners(), colours.ink(), 2);
        if (stepping) paintStep(strokes, made.get(made.size() - 1), colours);
        for (Cut cut : made) if (cut.fault() != Fault.NONE) mark(g, map, cut);
        if (made.size() <= 30) number(strokes, made);
    }

    private static Color edge(StageColours colours, Color colour) {
        return MethodColours.edgeOn(colours.ground(), colour);
    }

    private List<Place> corners(Cut cut) {
        List<Place> corners = figure.corners();
        return List.of(corners.get(cut.a()), corners.get(cut.b()), corners.get(cut.c()));
    }

    private void paintStep(Strokes strokes, Cut cut, StageColours colours) {
        List<Place> corners = corners(cut);
        strokes.line(corners.get(0), corners.get(2), colours.focus(), 4);
    }

    /** In the middle of the triangle, shared with its number: the number stands above. */
    private void mark(Graphics2D g, PlaneMap map, Cut cut) {
        Place middle = middle(cut);
        PixelMark.EXTRA.paint(
                g, map.viewX(middle.x()) - MARK / 2, map.viewY(middle.y()) - MARK / 2, MARK);
    }

    private void number(Strokes strokes, List<Cut> made) {
        for (int i = 0; i < made.size(); i++)
            strokes.words(
                    String.valueOf(i + 1),
                    middle(made.get(i)),
                    0,
                    made.get(i).fault() == Fault.NONE ? 0 : MARK);
    }

    private Place middle(Cut cut) {
        double x = 0;
        double y = 0;
        for (Place corner : corners(cut)) {
            x += corner.x() / 3;
            y += corner.y() / 3;
        }
        return new Place(x, y);
    }
}
