package rasterlab.app.canvas;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.OptionalDouble;

/** An arrow at the edge of a stage, which points to a point that is out of sight. */
public final class EdgeArrow {
    /** Tip, wings and notch of an arrow to the right, its middle at 0, as shares of its size. */
    private static final double[][] SHAPE = {{0.5, 0}, {-0.3, 0.42}, {-0.08, 0}, {-0.3, -0.42}};

    private EdgeArrow() {}

    /**
     * Where a handle of that size lies: around its point where that is in sight, else at the edge
     * and clear of the buttons.
     *
     * @param point in view units, as the others are
     * @param sight what rulers and the note leave of the stage
     * @param buttons over it
     */
    public static Rectangle place(Point2D point, int size, Rectangle sight, Rectangle buttons) {
        double left = point.getX() - size / 2.0;
        double top = point.getY() - size / 2.0;
        if (isSeen(point, sight, buttons))
            return new Rectangle((int) Math.round(left), (int) Math.round(top), size, size);
        var square =
                new Rectangle(
                        Rulers.square(point.getX(), sight.x, sight.x + sight.width, size),
                        Rulers.square(point.getY(), sight.y, sight.y + sight.height, size),
                        size,
                        size);
        return ZoomButtons.clear(square, point, sight, buttons);
    }

    /**
     * The angle from a handle's place to its point, clockwise from the right; none if it is seen.
     */
    public static OptionalDouble towards(
            Point2D point, Rectangle place, Rectangle sight, Rectangle buttons) {
        if (isSeen(point, sight, buttons)) return OptionalDouble.empty();
        return OptionalDouble.of(
                Math.atan2(point.getY() - place.getCenterY(), point.getX() - place.getCenterX()));
    }

    private static boolean isSeen(Point2D point, Rectangle sight, Rectangle buttons) {
        return sight.contains(point) && !buttons.contains(point);
    }

    /**
     * Paints an arrow that fills a component.
     *
     * @param g antialiased
     * @param angle clockwise from the right
     */
    public static void paint(
            Graphics2D g,
            StageColors colors,
            int width,
            int height,
            double angle,
            boolean focused) {
        double size = Math.min(width, height) - 4;
        var arrow = new Path2D.Double();
        for (double[] corner : SHAPE)
            if (arrow.getCurrentPoint() == null) arrow.moveTo(corner[0], corner[1]);
            else arrow.lineTo(corner[0], corner[1]);
        arrow.closePath();
        var placed = AffineTransform.getTranslateInstance(width / 2.0, height / 2.0);
        placed.rotate(angle);
        placed.scale(size, size);
        arrow.transform(placed);
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(4, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(arrow);
        g.setColor(focused ? colors.focus() : colors.ink());
        g.fill(arrow);
    }
}
