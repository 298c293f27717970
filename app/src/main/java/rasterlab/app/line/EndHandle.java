package rasterlab.app.line;

import java.awt.BasicStroke;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.RoundRectangle2D;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.EdgeArrow;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;

/**
 * The ring around one end of the segment: dragged by the mouse, moved by the arrow keys.
 *
 * <p>End A is a circle, end B a square, so that they differ without their letters.
 */
final class EndHandle extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    /** Pixels that Shift and an arrow key move. */
    private static final int FAR = 10;

    private final End end;
    private final transient LineLabModel model;

    /** Where the end lies if it is out of sight: the angle clockwise from the right. */
    private transient OptionalDouble away = OptionalDouble.empty();

    /**
     * @param dragged told where the pointer is while it drags, in this component's coordinates
     * @param released told the end of a drag
     * @param sought told that an end out of sight was clicked
     */
    EndHandle(
            End end,
            LineLabModel model,
            Consumer<Point> dragged,
            Runnable released,
            Runnable sought) {
        super(AccessibleRole.SLIDER);
        this.end = end;
        this.model = model;
        setName("end." + end);
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        var mouse = new Drag(dragged, released, sought);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        repaintOnFocus();
        bind(KeyEvent.VK_LEFT, -1, 0);
        bind(KeyEvent.VK_RIGHT, 1, 0);
        bind(KeyEvent.VK_UP, 0, -1);
        bind(KeyEvent.VK_DOWN, 0, 1);
    }

    private void bind(int key, int dx, int dy) {
        KeyBinding.whenFocused(
                this, KeyStroke.getKeyStroke(key, 0), () -> model.nudgeEnd(end, dx, dy));
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke(key, KeyEvent.SHIFT_DOWN_MASK),
                () -> model.nudgeEnd(end, FAR * dx, FAR * dy));
    }

    /**
     * Becomes an arrow to an end out of sight, which is not dragged from there; or a ring again.
     */
    void point(OptionalDouble angle, String hint) {
        setToolTipText(angle.isPresent() ? hint : null);
        if (angle.equals(away)) return;
        away = angle;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        StageColors colors = StageColors.now();
        if (away.isPresent()) {
            EdgeArrow.paint(g, colors, getWidth(), getHeight(), away.getAsDouble(), showsFocus());
            g.dispose();
            return;
        }
        double size = Math.min(getWidth(), getHeight()) - 6;
        Shape ring =
                end == End.A
                        ? new Ellipse2D.Double(3, 3, size, size)
                        : new RoundRectangle2D.Double(3.5, 3.5, size - 1, size - 1, 6, 6);
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(showsFocus() ? 5.5f : 4.5f));
        g.draw(ring);
        g.setColor(showsFocus() ? colors.focus() : colors.ink());
        g.setStroke(new BasicStroke(showsFocus() ? 3.5f : 2f));
        g.draw(ring);
        g.dispose();
    }

    /** One drag of the handle, which is one change for undo. */
    private final class Drag extends MouseAdapter {
        private final Consumer<Point> dragged;
        private final Runnable released;
        private final Runnable sought;
        private boolean dragging;

        Drag(Consumer<Point> dragged, Runnable released, Runnable sought) {
            this.dragged = dragged;
            this.released = released;
            this.sought = sought;
        }

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            dragging = away.isEmpty();
            if (dragging) model.beginDrag();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            if (dragging) dragged.accept(e.getPoint());
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            if (!dragging) return;
            dragging = false;
            model.endDrag();
            released.run();
        }

        @Override
        public void mouseClicked(MouseEvent e) {
            if (away.isPresent()) sought.run();
        }
    }
}
