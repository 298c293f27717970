package rasterlab.engine.raster;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/**
 * How a wrong pixel is marked in labs, reports and pictures: by its shape first, so that nobody
 * needs the colour. Where a pixel is in its place but of a wrong colour, {@link PictureDifference}
 * puts it into a saltire.
 */
public enum PixelMark {
    /** A ring: the exact picture lights this pixel, the method does not. */
    MISSING,
    /**
     * A cross: the method lights this pixel, the exact picture does not, or not again or not yet.
     */
    EXTRA,
    /** A square: the method lights this pixel though it has lit it before. */
    AGAIN;

    /** Vermillion (Okabe and Ito, 2008); nothing but a wrong pixel has it. Opaque, 0xAARRGGBB. */
    public static final int ARGB = 0xFFD55E00;

    public static final Color COLOR = new Color(ARGB);

    /** Draws the mark into the square with its upper left corner at (x, y), in view units. */
    public void paint(Graphics2D g, double x, double y, double size) {
        float width = (float) Math.max(1.2, size * 0.12);
        double inset = size * 0.22;
        outline(g, x + inset, y + inset, size - 2 * inset, width + 2.4f, Color.WHITE);
        outline(g, x + inset, y + inset, size - 2 * inset, width, COLOR);
    }

    private void outline(Graphics2D g, double x, double y, double size, float width, Color color) {
        g.setColor(color);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        switch (this) {
            case MISSING -> g.draw(new Ellipse2D.Double(x, y, size, size));
            case AGAIN -> g.draw(new Rectangle2D.Double(x, y, size, size));
            case EXTRA -> {
                g.draw(new Line2D.Double(x, y, x + size, y + size));
                g.draw(new Line2D.Double(x, y + size, x + size, y));
            }
        }
    }
}
