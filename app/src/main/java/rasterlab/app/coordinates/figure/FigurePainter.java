package rasterlab.app.coordinates.figure;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;

/** Draws marks of a figure. */
final class FigurePainter {
    /** View units beyond which nothing is drawn: Java2D's own numbers stay small. */
    private static final double FAR = 1e5;

    private static final double HEAD = 11;
    private static final double CROSS = 6;
    private static final double DOT = 4;
    private static final double WRONG = 30;
    private static final Color RED = new Color(0xE02020);
    private static final Color CYAN = new Color(0x00A6B8);

    private final Graphics2D g;
    private final PlaneMap map;
    private final StageColors colors;
    private final MarkLabelPlaces places;

    /**
     * @param marks all that will be painted
     * @param taken where no labels stand if there is room elsewhere
     */
    FigurePainter(
            Graphics2D g,
            PlaneMap map,
            StageColors colors,
            List<Mark> marks,
            List<Rectangle> taken) {
        this.g = g;
        this.map = map;
        this.colors = colors;
        var lines = new ArrayList<Line2D>();
        for (Mark mark : marks)
            if (mark instanceof Mark.LineMark line) add(lines, line.from(), line.to());
            else if (mark instanceof Mark.ArrowMark arrow) add(lines, arrow.from(), arrow.to());
        places = new MarkLabelPlaces(g.getClipBounds(), lines, taken);
    }

    private void add(List<Line2D> lines, StagePoint from, StagePoint to) {
        if (from.isFinite() && to.isFinite())
            lines.add(new Line2D.Double(x(from), y(from), x(to), y(to)));
    }

    void paint(Mark mark) {
        g.setColor(color(mark.ink()));
        g.setStroke(stroke(mark.ink().role()));
        if (mark instanceof Mark.LineMark line) path(List.of(line.from(), line.to()));
        else if (mark instanceof Mark.PathMark path) path(path.places());
        else if (mark instanceof Mark.AreaMark area) area(area.corners());
        else if (mark instanceof Mark.ArrowMark arrow) arrow(arrow);
        else if (mark instanceof Mark.DotMark dot) dot(dot);
        else if (mark instanceof Mark.CrossMark cross) cross(cross);
        else if (mark instanceof Mark.WrongMark wrong) wrong(wrong);
        else if (mark instanceof Mark.WordsMark words) words(words);
        else if (mark instanceof Mark.Beside beside) drawLabel(beside);
    }

    private Color color(MarkInk ink) {
        return switch (ink.role()) {
            case OBJECT -> colors.ink();
            case GHOST, HELP -> colors.axis();
            case AXIS_X -> MethodColors.ORANGE;
            case AXIS_Y -> MethodColors.GREEN;
            case AXIS_Z, PLANE, EDGE -> MethodColors.SKY_BLUE;
            case EYE -> MethodColors.PURPLE;
            case WRONG, PRINTED -> MethodColors.VERMILLION;
            case LEFT_EYE -> RED;
            case RIGHT_EYE -> CYAN;
            case METHOD -> FigureColors.OWN.of(ink.method());
        };
    }

    private static BasicStroke stroke(MarkInk.Role role) {
        return switch (role) {
            case GHOST -> dashed(1.4f, 2f, 4f);
            case HELP -> dashed(1f, 5f, 5f);
            case WRONG, PRINTED -> dashed(2.2f, 8f, 4f);
            case PLANE -> new BasicStroke(1.2f);
            case EDGE -> new BasicStroke(4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);
            default -> new BasicStroke(2.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        };
    }

    private static BasicStroke dashed(float width, float on, float off) {
        return new BasicStroke(
                width,
                BasicStroke.CAP_ROUND,
                BasicStroke.JOIN_ROUND,
                10f,
                new float[] {on, off},
                0f);
    }

    private double x(StagePoint at) {
        return Math.max(-FAR, Math.min(FAR, map.viewX(at.x())));
    }

    private double y(StagePoint at) {
        return Math.max(-FAR, Math.min(FAR, map.viewY(at.y())));
    }

    private void path(List<StagePoint> places) {
        for (int i = 1; i < places.size(); i++) {
            StagePoint from = places.get(i - 1);
            StagePoint to = places.get(i);
            if (from.isFinite() && to.isFinite())
                g.draw(new Line2D.Double(x(from), y(from), x(to), y(to)));
        }
    }

    private void area(List<StagePoint> corners) {
        if (!corners.stream().allMatch(StagePoint::isFinite)) return;
        var shape = new Path2D.Double();
        for (StagePoint corner : corners)
            if (shape.getCurrentPoint() == null) shape.moveTo(x(corner), y(corner));
            else shape.lineTo(x(corner), y(corner));
        shape.closePath();
        Color line = g.getColor();
        g.setColor(new Color(line.getRed(), line.getGreen(), line.getBlue(), 45));
        g.fill(shape);
        g.setColor(line);
        g.draw(shape);
    }

    private void arrow(Mark.ArrowMark arrow) {
        if (!arrow.from().isFinite() || !arrow.to().isFinite()) return;
        double x = x(arrow.to());
        double y = y(arrow.to());
        double dx = x - x(arrow.from());
        double dy = y - y(arrow.from());
        double length = Math.hypot(dx, dy);
        g.draw(new Line2D.Double(x(arrow.from()), y(arrow.from()), x, y));
        if (length < 1) return;
        double right = dx / length;
        double down = dy / length;
        var head = new Path2D.Double();
        head.moveTo(x + 2 * right, y + 2 * down);
        head.lineTo(x - HEAD * right - HEAD / 3 * down, y - HEAD * down + HEAD / 3 * right);
        head.lineTo(x - HEAD * right + HEAD / 3 * down, y - HEAD * down - HEAD / 3 * right);
        head.closePath();
        g.fill(head);
        label(arrow.label(), x + 15 * right, y + 15 * down);
    }

    private void dot(Mark.DotMark dot) {
        if (!dot.at().isFinite()) return;
        double x = x(dot.at());
        double y = y(dot.at());
        g.fill(new Ellipse2D.Double(x - DOT, y - DOT, 2 * DOT, 2 * DOT));
        drawLabel(dot.label(), x, y);
    }

    private void cross(Mark.CrossMark cross) {
        if (!cross.at().isFinite()) return;
        double x = x(cross.at());
        double y = y(cross.at());
        g.draw(new Line2D.Double(x - CROSS, y - CROSS, x + CROSS, y + CROSS));
        g.draw(new Line2D.Double(x - CROSS, y + CROSS, x + CROSS, y - CROSS));
        drawLabel(cross.label(), x, y);
    }

    private void wrong(Mark.WrongMark wrong) {
        if (wrong.at().isFinite())
            wrong.kind().paint(g, x(wrong.at()) - WRONG / 2, y(wrong.at()) - WRONG / 2, WRONG);
    }

    private void words(Mark.WordsMark words) {
        if (words.at().isFinite()) label(words.label(), x(words.at()), y(words.at()));
    }

    private void drawLabel(Mark.Beside beside) {
        double half = g.getFontMetrics().stringWidth(beside.label()) / 2.0;
        if (beside.at().isFinite())
            label(beside.label(), x(beside.at()) + 6 + half, y(beside.at()));
    }

    /** Writes the text where it hides no lines. */
    private void drawLabel(String label, double x, double y) {
        if (label.isEmpty()) return;
        FontMetrics metrics = g.getFontMetrics();
        Rectangle place =
                places.take(x, y, metrics.stringWidth(label) + 8, metrics.getHeight() + 1);
        label(label, place.getCenterX(), place.getCenterY());
    }

    private void label(String label, double middleX, double middleY) {
        if (label.isEmpty()) return;
        FontMetrics metrics = g.getFontMetrics();
        Color ground = colors.ground();
        Plates.plate(
                g,
                label,
                (int) Math.round(middleX - metrics.stringWidth(label) / 2.0),
                (int) Math.round(middleY + metrics.getAscent() / 2.0 - 1),
                new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), 190),
                colors.ink());
    }
}
