package rasterlab.app.line.trace;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import rasterlab.app.canvas.StageColors;

/** A lozenge: of two methods only one lights this pixel, be it right or wrong. */
public final class SingleMethodMark extends FlatAbstractIcon {
    private static final int SIZE = 16;

    /** View units of a pixel from which on a lozenge can be told from a square. */
    private static final double ROOMY = 5;

    /** View units of a crowded pixel's mark: wider than the exact curve. */
    private static final double SMALLEST_DOT = 3;

    public SingleMethodMark() {
        super(SIZE, SIZE, null);
    }

    /**
     * Paints the mark whole, also where the pixel has a mark of its own, over which it is to be
     * painted.
     */
    public static void paint(Graphics2D g, StageColors colors, Rectangle2D pixel) {
        if (pixel.getWidth() < ROOMY) {
            double size = Math.max(SMALLEST_DOT, pixel.getWidth());
            g.setColor(colors.ink());
            g.fill(
                    new Rectangle2D.Double(
                            pixel.getCenterX() - size / 2,
                            pixel.getCenterY() - size / 2,
                            size,
                            size));
            return;
        }
        Shape lozenge = lozenge(pixel);
        double width = Math.max(1.4, pixel.getWidth() * 0.09);
        double halo = Math.min(2.4, pixel.getWidth() * 0.15);
        outline(g, lozenge, (float) (width + halo), colors.ground());
        outline(g, lozenge, (float) width, colors.ink());
    }

    private static Shape lozenge(Rectangle2D pixel) {
        var corners = new Path2D.Double();
        corners.moveTo(pixel.getCenterX(), pixel.getMinY());
        corners.lineTo(pixel.getMaxX(), pixel.getCenterY());
        corners.lineTo(pixel.getCenterX(), pixel.getMaxY());
        corners.lineTo(pixel.getMinX(), pixel.getCenterY());
        corners.closePath();
        return corners;
    }

    private static void outline(Graphics2D g, Shape shape, float width, Color color) {
        g.setColor(color);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(shape);
    }

    @Override
    protected void paintIcon(Component c, Graphics2D g) {
        double side = SIZE * 0.7;
        double inset = (SIZE - side) / 2;
        paint(g, StageColors.now(), new Rectangle2D.Double(inset, inset, side, side));
    }
}
