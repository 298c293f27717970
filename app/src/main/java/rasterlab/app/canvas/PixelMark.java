package rasterlab.app.canvas;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import javax.swing.Icon;

/** How a wrong pixel is marked: by its shape first, so that nobody needs the colour. */
public enum PixelMark {
    /** A ring: the exact picture lights this pixel, the method does not. */
    MISSING,
    /** A cross: the method lights this pixel, the exact picture does not. */
    EXTRA;

    public static final Color COLOUR = MethodColours.VERMILLION;

    /** Draws the mark into the square with its upper left corner at (x, y), in view units. */
    public void paint(Graphics2D g, double x, double y, double size) {
        float width = (float) Math.max(1.2, size * 0.12);
        double inset = size * 0.22;
        outline(g, x + inset, y + inset, size - 2 * inset, width + 2.4f, Color.WHITE);
        outline(g, x + inset, y + inset, size - 2 * inset, width, COLOUR);
    }

    private void outline(Graphics2D g, double x, double y, double size, float width, Color colour) {
        g.setColor(colour);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        if (this == MISSING) {
            g.draw(new Ellipse2D.Double(x, y, size, size));
        } else {
            g.draw(new Line2D.Double(x, y, x + size, y + size));
            g.draw(new Line2D.Double(x, y + size, x + size, y));
        }
    }

    /** The mark beside its count in the inspector. */
    public Icon icon() {
        return new Icon() {
            @Override
            public void paintIcon(Component c, Graphics g, int x, int y) {
                var copy = (Graphics2D) g.create();
                copy.setRenderingHint(
                        RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
                copy.setRenderingHint(
                        RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
                PixelMark.this.paint(copy, x, y, UIScale.scale(16));
                copy.dispose();
            }

            @Override
            public int getIconWidth() {
                return UIScale.scale(16);
            }

            @Override
            public int getIconHeight() {
                return UIScale.scale(16);
            }
        };
    }
}
