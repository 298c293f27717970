package rasterlab.app.practice;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlaneRulers;
import rasterlab.app.canvas.Rulers;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.ZoomedGrid;
import rasterlab.app.practice.Board.BoardCell;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;

/** Where a board lies in its stage, with rulers. */
record BoardFrame(BoardSpace space, PlaneMap map, Dimension view) {
    /** Pixels around what is drawn, where a wrong answer may lie. */
    private static final int AROUND = 2;

    /** Shows the whole board; a wrong answer moves nothing. */
    static BoardFrame of(Board board, Dimension view) {
        List<Point2D> points = board.figures().stream().flatMap(BoardFrame::points).toList();
        Rectangle2D world = new Rectangle2D.Double();
        if (!points.isEmpty()) {
            world = new Rectangle2D.Double(points.get(0).getX(), points.get(0).getY(), 0, 0);
            for (Point2D point : points) world.add(point);
        }
        Rectangle sight = Rulers.inside(view);
        return new BoardFrame(
                board.space(),
                switch (board.space()) {
                    case PIXELS -> pixels(world, sight);
                    case PLANE, SPACE -> PlaneMap.fitting(world, sight, PlaneAxes.GEOMETRY);
                    case DEPTH -> PlaneMap.fitting(world, sight, PlaneAxes.GRAPH);
                },
                view);
    }

    /** This board with another part of it in sight. */
    BoardFrame by(PlaneMap other) {
        return new BoardFrame(space, other, view);
    }

    /** Where all lies when it is nearer by a factor and a view point keeps its place. */
    PlaneMap zoomed(double factor, Point2D at) {
        return space == BoardSpace.PIXELS ? map(grid().zoomed(factor, at)) : map.zoomed(factor, at);
    }

    private static PlaneMap map(ZoomedGrid grid) {
        return new PlaneMap(grid.originX(), grid.originY(), grid.cell(), grid.cell());
    }

    private ZoomedGrid grid() {
        return new ZoomedGrid(map.originX(), map.originY(), map.scaleX());
    }

    private static PlaneMap pixels(Rectangle2D world, Rectangle sight) {
        int left = (int) Math.ceil(world.getMinX()) - AROUND;
        int top = (int) Math.ceil(world.getMinY()) - AROUND;
        int right = (int) Math.floor(world.getMaxX()) + AROUND;
        int bottom = (int) Math.floor(world.getMaxY()) + AROUND;
        ZoomedGrid grid =
                ZoomedGrid.fitting(
                        new Rectangle(left, top, right - left + 1, bottom - top + 1), sight);
        return map(grid);
    }

    private static Stream<Point2D> points(BoardFigure figure) {
        if (figure instanceof BoardCell cell && cell.look() != FigureLook.WRONG)
            return Stream.of(new Point2D.Double(cell.x(), cell.y()));
        if (figure instanceof BoardPath path) return path.points().stream();
        if (figure instanceof BoardDot dot && dot.look() != FigureLook.WRONG)
            return Stream.of(dot.at());
        return Stream.empty();
    }

    void paintGrid(Graphics2D g, Font font, Locale locale) {
        if (space == BoardSpace.PIXELS) rulers(font).paintGrid(g);
        else if (space != BoardSpace.SPACE) planeRulers(font, locale).paintGrid(g);
    }

    void paintMargins(Graphics2D g, Font font, Locale locale) {
        if (space == BoardSpace.PIXELS) rulers(font).paintMargins(g);
        else if (space != BoardSpace.SPACE) planeRulers(font, locale).paintMargins(g);
    }

    private Rulers rulers(Font font) {
        return new Rulers(grid(), view, StageColors.now(), font);
    }

    private PlaneRulers planeRulers(Font font, Locale locale) {
        return new PlaneRulers(map, view, StageColors.now(), font, locale, 0);
    }

    /** The pixel there. */
    Point pixelAt(Point view) {
        return grid().pixelAt(view.x, view.y);
    }
}
