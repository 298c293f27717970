package rasterlab.app.light.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.Locale;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;
import rasterlab.app.light.ColorChoice;
import rasterlab.contract.ColorModel;

/**
 * The colour cube as a room one looks into: its far walls in their colours, its near edges as
 * lines, the colour inside with its steps along red, green and blue and its foot on the grey
 * diagonal.
 */
final class CubePainter {
    /** Squares along an edge of a wall. */
    private static final int SQUARES = 24;

    private static final double SIZE = 0.52;

    /** View units from a corner to the middle of its name above or below, at most. */
    private static final double LABEL = 30;

    /** View units from a corner to its name. */
    private static final double GAP = 12;

    /** The distance from the cube's middle to a corner, in edges. */
    private static final double CORNER = Math.sqrt(3) / 2;

    /** View units from a name to the stage's edge. */
    private static final int EDGE = 6;

    private final Graphics2D g;
    private final ColorChoice color;
    private final Texts texts;
    private final double middleX;
    private final double middleY;
    private final double unit;
    private final int width;
    private final int height;

    CubePainter(Graphics2D g, ColorChoice color, Texts texts, int width, int height) {
        this.g = g;
        this.color = color;
        this.texts = texts;
        middleX = width / 2.0;
        middleY = height / 2.0;
        this.width = width;
        this.height = height;
        double name = LABEL + g.getFontMetrics().getHeight() / 2.0 + EDGE;
        int small = Math.min(width, height);
        unit = Math.max(1, Math.min(SIZE * small, (small / 2.0 - name) / CORNER));
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }

    void paint() {
        for (int axis = 0; axis < 3; axis++) wall(axis, far(axis) ? 1 : 0);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        edges();
        inside();
        swatch();
        corners();
    }

    /** Depth towards the eye of a point of the cube, of which each coordinate is from 0 to 1. */
    private double depth(double r, double g, double b) {
        double x = r - 0.5;
        double y = g - 0.5;
        double z = b - 0.5;
        double forward = x * Math.sin(color.yaw()) + y * Math.cos(color.yaw());
        return -forward * Math.cos(color.pitch()) + z * Math.sin(color.pitch());
    }

    /** Whether of the two walls across an axis the one at 1 is farther. */
    private boolean far(int axis) {
        double[] one = {0.5, 0.5, 0.5};
        one[axis] = 1;
        return depth(one[0], one[1], one[2]) < 0;
    }

    private Point2D at(double r, double g, double b) {
        double x = r - 0.5;
        double y = g - 0.5;
        double z = b - 0.5;
        double right = x * Math.cos(color.yaw()) - y * Math.sin(color.yaw());
        double forward = x * Math.sin(color.yaw()) + y * Math.cos(color.yaw());
        double up = z * Math.cos(color.pitch()) + forward * Math.sin(color.pitch());
        return new Point2D.Double(middleX + unit * right, middleY - unit * up);
    }

    private void wall(int axis, double level) {
        double step = 1.0 / SQUARES;
        for (int i = 0; i < SQUARES; i++)
            for (int j = 0; j < SQUARES; j++) {
                double[] rgb = point(axis, level, (i + 0.5) * step, (j + 0.5) * step);
                g.setColor(new Color((float) rgb[0], (float) rgb[1], (float) rgb[2]));
                var square = new Path2D.Double();
                for (int k = 0; k < 4; k++) {
                    double u = (i + (k == 1 || k == 2 ? 1.04 : 0)) * step;
                    double v = (j + (k >= 2 ? 1.04 : 0)) * step;
                    double[] corner = point(axis, level, Math.min(1, u), Math.min(1, v));
                    Point2D at = at(corner[0], corner[1], corner[2]);
                    if (k == 0) square.moveTo(at.getX(), at.getY());
                    else square.lineTo(at.getX(), at.getY());
                }
                square.closePath();
                g.fill(square);
            }
    }

    private static double[] point(int axis, double level, double u, double v) {
        var point = new double[3];
        point[axis] = level;
        point[(axis + 1) % 3] = u;
        point[(axis + 2) % 3] = v;
        return point;
    }

    private void edges() {
        g.setStroke(new BasicStroke(1.4f));
        g.setColor(StageColors.now().ink());
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < 4; k++) {
                double[] from = point(axis, 0, k & 1, k >> 1);
                double[] to = point(axis, 1, k & 1, k >> 1);
                g.draw(new Line2D.Double(at(from[0], from[1], from[2]), at(to[0], to[1], to[2])));
            }
    }

    private void inside() {
        double[] rgb = color.in(ColorModel.RGB);
        double gray = (rgb[0] + rgb[1] + rgb[2]) / 3;
        dashed(at(0, 0, 0), at(1, 1, 1), Color.GRAY);
        line(at(0, 0, 0), at(rgb[0], 0, 0), new Color(0xE03030));
        line(at(rgb[0], 0, 0), at(rgb[0], rgb[1], 0), new Color(0x20A030));
        line(at(rgb[0], rgb[1], 0), at(rgb[0], rgb[1], rgb[2]), new Color(0x3050E0));
        dashed(at(gray, gray, gray), at(rgb[0], rgb[1], rgb[2]), Color.BLACK);
        ball(at(gray, gray, gray), 5, new Color((float) gray, (float) gray, (float) gray));
        ball(at(rgb[0], rgb[1], rgb[2]), 10, new Color(color.rgb()));
    }

    private void line(Point2D from, Point2D to, Color color) {
        g.setStroke(new BasicStroke(5f, 1, 1));
        g.setColor(Color.WHITE);
        g.draw(new Line2D.Double(from, to));
        g.setStroke(new BasicStroke(2.6f, 1, 1));
        g.setColor(color);
        g.draw(new Line2D.Double(from, to));
    }

    private void dashed(Point2D from, Point2D to, Color color) {
        g.setStroke(new BasicStroke(3.4f, 1, 1));
        g.setColor(new Color(255, 255, 255, 150));
        g.draw(new Line2D.Double(from, to));
        g.setStroke(new BasicStroke(1.6f, 1, 1, 10f, new float[] {6f, 5f}, 0f));
        g.setColor(color);
        g.draw(new Line2D.Double(from, to));
    }

    private void ball(Point2D at, double radius, Color fill) {
        var ball =
                new Ellipse2D.Double(
                        at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius);
        g.setColor(fill);
        g.fill(ball);
        g.setStroke(new BasicStroke(2f));
        g.setColor(MethodColors.inkOn(fill));
        g.draw(ball);
    }

    private void corners() {
        g.setFont(g.getFont().deriveFont(Font.BOLD));
        for (int k = 0; k < 8; k++) {
            double[] rgb = {k & 1, k >> 1 & 1, k >> 2};
            Point2D at = at(rgb[0], rgb[1], rgb[2]);
            ball(at, 5, new Color((float) rgb[0], (float) rgb[1], (float) rgb[2]));
            String name = texts.text("corner." + k);
            var metrics = g.getFontMetrics();
            Point2D away =
                    away(
                            at.getX() - middleX,
                            at.getY() - middleY,
                            metrics.stringWidth(name),
                            metrics.getHeight());
            label(name, at.getX() + away.getX(), at.getY() + away.getY());
        }
    }

    /**
     * The vector from a corner to the middle of its name, which lies outwards and as near as leaves
     * the corner free.
     *
     * @param dx from the cube's middle to the corner; so is dy
     */
    static Point2D away(double dx, double dy, double wide, double high) {
        double length = Math.hypot(dx, dy);
        double right = length < 1 ? 0 : dx / length;
        double down = length < 1 ? 1 : dy / length;
        double far =
                Math.min((GAP + wide / 2) / Math.abs(right), (GAP + high / 2) / Math.abs(down));
        return new Point2D.Double(far * right, far * down);
    }

    private void label(String name, double x, double y) {
        var metrics = g.getFontMetrics();
        StageColors colors = StageColors.now();
        int wide = metrics.stringWidth(name);
        Plates.plate(
                g,
                name,
                (int) Math.max(EDGE, Math.min(width - EDGE - wide, x - wide / 2.0)),
                (int)
                        Math.max(
                                EDGE + metrics.getAscent(),
                                Math.min(
                                        height - EDGE - metrics.getDescent(),
                                        y + metrics.getAscent() / 2.0)),
                colors.ground(),
                colors.ink());
    }

    /** Draws the colour itself, large enough to be judged. */
    private void swatch() {
        String code = String.format(Locale.ROOT, "#%06X", color.rgb());
        int wide = (int) Math.max(g.getFontMetrics().stringWidth(code) + 20, unit * 0.28);
        int high = (int) Math.max(g.getFontMetrics().getHeight() + 12, unit * 0.28);
        var fill = new Color(color.rgb());
        g.setColor(fill);
        g.fillRoundRect(8, 8, wide, high, 12, 12);
        g.setColor(StageColors.now().axis());
        g.setStroke(new BasicStroke(1.2f));
        g.drawRoundRect(8, 8, wide, high, 12, 12);
        g.setColor(MethodColors.inkOn(fill));
        g.drawString(code, 18, 8 + high - 10);
    }
}
