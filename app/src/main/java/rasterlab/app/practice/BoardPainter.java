package rasterlab.app.practice;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Board.BoardCell;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.FigureLook;

/**
 * Draws a board's figures; what is newest, asked or wrong has a sign of its own beside its colour.
 */
final class BoardPainter {
    private static final float THIN = 1.5f;
    private static final float THICK = 3.5f;

    private final Graphics2D g;
    private final PlaneMap map;
    private final StageColors colors;
    private final Texts texts;

    BoardPainter(Graphics2D g, PlaneMap map, StageColors colors, Texts texts) {
        this.g = g;
        this.map = map;
        this.colors = colors;
        this.texts = texts;
    }

    void paint(Board board) {
        for (BoardFigure figure : board.figures())
            if (figure instanceof BoardCell cell) paint(cell);
            else if (figure instanceof BoardPath path) paint(path);
            else if (figure instanceof BoardDot dot) paint(dot);
    }

    private Color color(FigureLook look) {
        return switch (look) {
            case GIVEN -> colors.ink();
            case WALL -> colors.axis();
            case DONE -> MethodColors.SKY_BLUE;
            case NEWEST -> MethodColors.ORANGE;
            case ASKED -> MethodColors.BLUE;
            case WRONG -> MethodColors.VERMILLION;
        };
    }

    /** The view square of a pixel. */
    Rectangle2D square(int x, int y) {
        double cell = map.scaleX();
        return new Rectangle2D.Double(
                map.viewX(x - 0.5) + 1, map.viewY(y - 0.5) + 1, cell - 2, cell - 2);
    }

    private void paint(BoardCell cell) {
        Rectangle2D square = square(cell.x(), cell.y());
        Color color = color(cell.look());
        if (cell.look() != FigureLook.WRONG) {
            g.setColor(color);
            g.fill(square);
        }
        g.setColor(MethodColors.edgeOn(colors.ground(), color));
        g.setStroke(new BasicStroke(THIN));
        g.draw(square);
        if (cell.look() == FigureLook.WRONG) cross(square);
        if (cell.look() == FigureLook.NEWEST) {
            double size = map.scaleX() / 4;
            g.setColor(MethodColors.inkOn(color));
            g.fill(
                    new Ellipse2D.Double(
                            square.getCenterX() - size / 2,
                            square.getCenterY() - size / 2,
                            size,
                            size));
        }
    }

    private void cross(Rectangle2D in) {
        g.setColor(MethodColors.lineOn(colors.ground(), MethodColors.VERMILLION));
        g.setStroke(new BasicStroke(THICK));
        double pad = in.getWidth() / 5;
        double left = in.getMinX() + pad;
        double right = in.getMaxX() - pad;
        g.draw(new Line2D.Double(left, in.getMinY() + pad, right, in.getMaxY() - pad));
        g.draw(new Line2D.Double(left, in.getMaxY() - pad, right, in.getMinY() + pad));
    }

    private void paint(BoardPath path) {
        if (path.points().isEmpty()) return;
        var shape = new Path2D.Double();
        for (Point2D point : path.points())
            if (shape.getCurrentPoint() == null) shape.moveTo(viewX(point), viewY(point));
            else shape.lineTo(viewX(point), viewY(point));
        if (path.closed()) shape.closePath();
        g.setColor(MethodColors.lineOn(colors.ground(), color(path.look())));
        g.setStroke(stroke(path.look()));
        g.draw(shape);
    }

    /** Dashes the things that are asked for, so that they are seen on the given ones. */
    private static BasicStroke stroke(FigureLook look) {
        boolean thin =
                look == FigureLook.GIVEN || look == FigureLook.DONE || look == FigureLook.WALL;
        float wide = thin ? THIN : THICK;
        return look == FigureLook.ASKED
                ? new BasicStroke(
                        2 * THICK,
                        BasicStroke.CAP_BUTT,
                        BasicStroke.JOIN_ROUND,
                        10,
                        new float[] {10, 6},
                        0)
                : new BasicStroke(wide, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    private void paint(BoardDot dot) {
        double size = PictureType.scaled(9);
        Rectangle2D box =
                new Rectangle2D.Double(
                        viewX(dot.at()) - size / 2, viewY(dot.at()) - size / 2, size, size);
        if (dot.look() == FigureLook.WRONG) {
            double large = 2 * size;
            cross(
                    new Rectangle2D.Double(
                            box.getCenterX() - large / 2,
                            box.getCenterY() - large / 2,
                            large,
                            large));
        } else {
            g.setColor(MethodColors.lineOn(colors.ground(), color(dot.look())));
            g.fill(new Ellipse2D.Double(box.getX(), box.getY(), size, size));
        }
        if (!dot.label().isEmpty()) label(dot, size);
    }

    private void label(BoardDot dot, double size) {
        String words = texts.textOr("label." + dot.label(), dot.label());
        FontMetrics metrics = g.getFontMetrics();
        float x = (float) (viewX(dot.at()) + size);
        float y = (float) (viewY(dot.at()) - size / 2);
        g.setColor(colors.ground());
        g.fill(
                new Rectangle2D.Double(
                        x - 1,
                        y - metrics.getAscent(),
                        metrics.stringWidth(words) + 2,
                        metrics.getAscent() + metrics.getDescent()));
        g.setColor(colors.ink());
        g.drawString(words, x, y);
    }

    private double viewX(Point2D point) {
        return map.viewX(point.getX());
    }

    private double viewY(Point2D point) {
        return map.viewY(point.getY());
    }
}
