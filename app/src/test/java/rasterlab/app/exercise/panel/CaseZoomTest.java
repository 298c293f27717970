package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class CaseZoomTest {
    private static CaseCanvas canvas() {
        var canvas =
                new CaseCanvas(
                        Texts.of("exercise", Language.ENGLISH),
                        failure -> {
                            throw new AssertionError(failure);
                        });
        canvas.setSize(400, 300);
        return canvas;
    }

    private static JPanel sized() {
        var panel = new JPanel();
        panel.setSize(400, 300);
        return panel;
    }

    private static void turn(JComponent canvas, int x, int y, int notches) {
        canvas.dispatchEvent(
                new MouseWheelEvent(
                        canvas, MouseWheelEvent.MOUSE_WHEEL, 0, 0, x, y, 0, false, 0, 3, notches));
    }

    private static Point2D placed(CaseZoom zoom, double x, double y) {
        return zoom.transform().transform(new Point2D.Double(x, y), null);
    }

    @Test
    void wheelKeepsThePointUnderThePointer() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    JPanel canvas = sized();
                    var zoom = new CaseZoom(canvas);
                    turn(canvas, 100, 200, -3);
                    assertTrue(zoom.transform().getScaleX() > 1.5);
                    Point2D same = placed(zoom, 100, 200);
                    assertEquals(100, same.getX(), 1e-9);
                    assertEquals(200, same.getY(), 1e-9);
                });
    }

    @Test
    void nothingButThePicturesComesInSight() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    JPanel canvas = sized();
                    var zoom = new CaseZoom(canvas);
                    turn(canvas, 400, 300, -9);
                    turn(canvas, 0, 0, 5);
                    Point2D first = placed(zoom, 0, 0);
                    Point2D last = placed(zoom, 400, 300);
                    assertTrue(first.getX() <= 0 && first.getY() <= 0, first.toString());
                    assertTrue(last.getX() >= 400 && last.getY() >= 300, last.toString());
                    turn(canvas, 30, 40, 50);
                    assertEquals(new AffineTransform(), zoom.transform());
                });
    }

    @Test
    void blinkingGoesBackToTheViewBefore() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    CaseCanvas canvas = canvas();
                    canvas.choose("difference");
                    canvas.toggleBlink();
                    assertEquals("blink", canvas.view());
                    canvas.toggleBlink();
                    assertEquals("difference", canvas.view());
                    canvas.close();
                });
    }
}
