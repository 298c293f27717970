package rasterlab.app.exercise.panel;

import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import javax.swing.JComponent;

/**
 * How far the pictures of a case are drawn larger: the wheel zooms about the pointer, another case
 * is shown whole again.
 */
final class CaseZoom {
    /** Zoom factor per wheel notch. */
    private static final double PER_NOTCH = 1.25;

    private static final double MOST = 16;

    private final JComponent canvas;
    private double scale = 1;

    /** Where the component's corner (0, 0) goes, in its pixels; never right of or below it. */
    private double x;

    private double y;

    CaseZoom(JComponent canvas) {
        this.canvas = canvas;
        canvas.addMouseWheelListener(this::turn);
    }

    private void turn(MouseWheelEvent e) {
        zoom(Math.pow(PER_NOTCH, -e.getPreciseWheelRotation()), e.getX(), e.getY());
        e.consume();
    }

    /** Zooms by a factor about a point of the component. */
    void zoom(double factor, double atX, double atY) {
        double next = Math.max(1, Math.min(MOST, scale * factor));
        x = within(atX - (atX - x) * next / scale, canvas.getWidth(), next);
        y = within(atY - (atY - y) * next / scale, canvas.getHeight(), next);
        scale = next;
        canvas.repaint();
    }

    /** Keeps the component filled. */
    private static double within(double corner, int size, double scale) {
        return Math.max(size * (1 - scale), Math.min(0, corner));
    }

    /** Shows all, as it is without zoom. */
    void reset() {
        scale = 1;
        x = 0;
        y = 0;
        canvas.repaint();
    }

    AffineTransform transform() {
        return new AffineTransform(scale, 0, 0, scale, x, y);
    }
}
