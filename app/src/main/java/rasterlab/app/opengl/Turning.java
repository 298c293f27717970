package rasterlab.app.opengl;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;

/** Turns the scene with the mouse: a drag is one change for undo, the wheel moves the eye. */
final class Turning extends MouseAdapter {
    private static final double DEGREES = 0.5;
    private static final double WHEEL = 1.06;

    private final OpenGlLabModel model;
    private final Runnable pressed;
    private final Consumer<Optional<Point>> pointed;
    private Point last = new Point();

    /**
     * @param pressed told when a drag begins
     * @param pointed told where the mouse is, in the component's view units, and when it is gone
     */
    Turning(OpenGlLabModel model, Runnable pressed, Consumer<Optional<Point>> pointed) {
        this.model = model;
        this.pressed = pressed;
        this.pointed = pointed;
    }

    void listenTo(Component component) {
        component.addMouseListener(this);
        component.addMouseMotionListener(this);
        component.addMouseWheelListener(this);
    }

    @Override
    public void mousePressed(MouseEvent e) {
        pressed.run();
        last = e.getPoint();
        model.beginDrag();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        int right = e.getX() - last.x;
        int down = e.getY() - last.y;
        last = e.getPoint();
        model.move(choice -> choice.turned(right * DEGREES, down * DEGREES));
        pointed.accept(Optional.of(e.getPoint()));
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        model.endDrag();
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        pointed.accept(Optional.of(e.getPoint()));
    }

    @Override
    public void mouseExited(MouseEvent e) {
        pointed.accept(Optional.empty());
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        model.move(choice -> choice.dollied(Math.pow(WHEEL, e.getPreciseWheelRotation())));
    }
}
