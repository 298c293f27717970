package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.FigureLook;

/**
 * Space in a picture: y to the right and z upward to one scale, x to the lower left, half as long.
 */
final class SpaceView {
    /** The way that a unit of x goes to the left, and down. */
    private static final double SLANT = Math.sqrt(2) / 4;

    private SpaceView() {}

    static Point2D at(double x, double y, double z) {
        return new Point2D.Double(y - SLANT * x, z - SLANT * x);
    }

    /** The point [x, y, z]. */
    static Point2D at(JsonNode xyz) {
        return at(number(xyz, 0), number(xyz, 1), number(xyz, 2));
    }

    static double number(JsonNode of, int index) {
        return of.path(index).doubleValue();
    }

    /** An arrow from a point as far as a vector goes, times a factor. */
    static BoardPath arrow(JsonNode from, JsonNode vector, double factor, FigureLook look) {
        Point2D end =
                at(
                        number(from, 0) + factor * number(vector, 0),
                        number(from, 1) + factor * number(vector, 1),
                        number(from, 2) + factor * number(vector, 2));
        return new BoardPath(List.of(at(from), end), false, look);
    }

    /** The axes, from the origin as far as what is drawn. */
    static List<BoardFigure> axes(double reach) {
        var figures = new ArrayList<BoardFigure>();
        addAxis(figures, "x", at(reach, 0, 0));
        addAxis(figures, "y", at(0, reach, 0));
        addAxis(figures, "z", at(0, 0, reach));
        return figures;
    }

    private static void addAxis(List<BoardFigure> figures, String name, Point2D end) {
        figures.add(new BoardPath(List.of(new Point2D.Double(), end), false, FigureLook.WALL));
        figures.add(new BoardDot(end, name, FigureLook.WALL));
    }

    /** A line from a point down or up to z = 0 and from there to the x axis, to tell its depth. */
    static BoardPath foot(JsonNode point) {
        double x = number(point, 0);
        double y = number(point, 1);
        return new BoardPath(List.of(at(point), at(x, y, 0), at(x, 0, 0)), false, FigureLook.WALL);
    }

    /** The largest coordinate in size of points [[x, y, z], …]; 1 at least. */
    static double reach(JsonNode points) {
        double reach = 1;
        for (JsonNode point : points)
            for (JsonNode number : point) reach = Math.max(reach, Math.abs(number.doubleValue()));
        return reach;
    }
}
