package rasterlab.app.canvas;

import java.awt.BasicStroke;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.OptionalDouble;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;

/** The ring around one point of a plane: dragged by the mouse, moved by the arrow keys. */
final class PlaneHandle extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    /** How many times as far Shift and an arrow key move. */
    private static final int FAR = 10;

    /** The plane as its handles see it. */
    interface DragTarget {
        void beginDrag();

        void endDrag();

        /** The pointer drags the point here, in the plane's coordinates. */
        void drag(PlanePoint point, Point view);

        /** Moves the point by so many key steps to the right and upward. */
        void nudge(PlanePoint point, int right, int up);

        void remove(PlanePoint point);

        void focused(PlaneHandle handle);

        /** A point out of sight was clicked. */
        void seek();
    }

    private final transient DragTarget plane;
    private transient PlanePoint point;

    /** Where the point lies if it is out of sight: the angle clockwise from the right. */
    private transient OptionalDouble away = OptionalDouble.empty();

    PlaneHandle(PlanePoint point, DragTarget plane) {
        super(AccessibleRole.SLIDER);
        this.plane = plane;
        setName(point.name());
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        var mouse = new Drag();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addFocusListener(mouse);
        bind(KeyEvent.VK_LEFT, -1, 0);
        bind(KeyEvent.VK_RIGHT, 1, 0);
        bind(KeyEvent.VK_UP, 0, 1);
        bind(KeyEvent.VK_DOWN, 0, -1);
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke(KeyEvent.VK_DELETE, 0),
                () -> plane.remove(this.point));
        show(point);
    }

    private void bind(int key, int right, int up) {
        KeyBinding.whenFocused(
                this, KeyStroke.getKeyStroke(key, 0), () -> plane.nudge(point, right, up));
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke(key, KeyEvent.SHIFT_DOWN_MASK),
                () -> plane.nudge(point, FAR * right, FAR * up));
    }

    /** Shows the same point elsewhere, or under another name. */
    void show(PlanePoint next) {
        point = next;
        getAccessibleContext().setAccessibleName(next.accessibleName());
        setToolTipText(next.accessibleName());
        repaint();
    }

    /**
     * Becomes an arrow to a point out of sight, which is not dragged from there; or a ring again.
     */
    void point(OptionalDouble angle) {
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
        Shape ring = ring(Math.min(getWidth(), getHeight()) - 6);
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(showsFocus() ? 5.5f : 4.5f));
        g.draw(ring);
        g.setColor(showsFocus() ? colors.focus() : colors.ink());
        g.setStroke(new BasicStroke(showsFocus() ? 3.5f : 2f));
        g.draw(ring);
        g.dispose();
    }

    private Shape ring(double size) {
        return switch (point.form()) {
            case CIRCLE -> new Ellipse2D.Double(3, 3, size, size);
            case SQUARE -> new RoundRectangle2D.Double(3.5, 3.5, size - 1, size - 1, 6, 6);
            case DIAMOND -> {
                double middle = 3 + size / 2;
                var diamond = new Path2D.Double();
                diamond.moveTo(middle, 3);
                diamond.lineTo(3 + size, middle);
                diamond.lineTo(middle, 3 + size);
                diamond.lineTo(3, middle);
                diamond.closePath();
                yield diamond;
            }
        };
    }

    /** One drag of the handle, which is one change for undo. */
    private final class Drag extends MouseAdapter implements FocusListener {
        private Point offset = new Point();
        private boolean dragging;

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            offset = new Point(e.getX() - getWidth() / 2, e.getY() - getHeight() / 2);
            dragging = away.isEmpty();
            if (dragging) plane.beginDrag();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            if (!dragging) return;
            plane.drag(
                    point, new Point(getX() + e.getX() - offset.x, getY() + e.getY() - offset.y));
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            if (dragging) plane.endDrag();
            dragging = false;
        }

        @Override
        public void mouseClicked(MouseEvent e) {
            if (away.isPresent()) plane.seek();
        }

        @Override
        public void focusGained(FocusEvent e) {
            plane.focused(PlaneHandle.this);
            repaint();
        }

        @Override
        public void focusLost(FocusEvent e) {
            repaint();
        }
    }
}
