package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.JPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.opengl.state.Setting;
import rasterlab.engine.raster.Raster;

/** OpenGL's window on its way; skipped without a display or without OpenGL. */
@Timeout(300)
class GlWindowTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final JPanel place = new JPanel(new BorderLayout());
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch mayGoOn = new CountDownLatch(1);
    private volatile Thread maker;
    private OpenGlLabModel model;
    private GlWindow window;
    private JFrame frame;
    private boolean unusable;

    @BeforeEach
    void hasDisplay() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
    }

    private void open(Supplier<GlCanvas> made) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model = new OpenGlLabModel(EventQueue::invokeLater, failures::add);
                    frame = new JFrame();
                    // Another process may test keys on this display.
                    frame.setFocusableWindowState(false);
                    frame.setContentPane(place);
                    frame.setSize(200, 150);
                    frame.setVisible(true);
                    window = new GlWindow(model, place, made, () -> unusable = true);
                    model.resize(64, 48);
                    window.open();
                });
    }

    @AfterEach
    void close() throws Exception {
        if (frame == null) return;
        EventQueue.invokeAndWait(frame::dispose);
        model.close();
        assertEquals(List.of(), failures);
    }

    private GlCanvas canvas() {
        return new GlCanvas(model, () -> unusable = true);
    }

    /** The canvas, whose making lasts until it may go on, whatever interrupts it. */
    private GlCanvas slowCanvas() {
        maker = Thread.currentThread();
        begun.countDown();
        for (boolean waits = true; waits; )
            try {
                mayGoOn.await();
                waits = false;
            } catch (InterruptedException e) {
                continue;
            }
        return canvas();
    }

    private static void events() throws Exception {
        for (int k = 0; k < 4; k++) EventQueue.invokeAndWait(() -> {});
    }

    @Test
    void windowComesAfterTheFirstPictureAndDraws() throws Exception {
        open(this::slowCanvas);
        begun.await();
        events();
        Raster first = model.state().pictures().software().orElseThrow();
        mayGoOn.countDown();
        window.settle();
        assertEquals(1, place.getComponentCount());
        while (!unusable && model.state().pictures().software().orElseThrow() == first) events();
        assumeFalse(unusable, "no OpenGL on this display");
        EventQueue.invokeAndWait(window::close);
        assertEquals(0, place.getComponentCount());
    }

    @Test
    void windowClosedOnItsWayNeverComesAndTheModelDraws() throws Exception {
        open(this::slowCanvas);
        begun.await();
        EventQueue.invokeAndWait(window::close);
        mayGoOn.countDown();
        maker.join(TimeUnit.MINUTES.toMillis(2));
        assertFalse(maker.isAlive(), "its thread has ended");
        events();
        assertEquals(0, place.getComponentCount());
        Raster before = model.state().pictures().software().orElseThrow();
        EventQueue.invokeAndWait(() -> model.set(Setting.SCENE, "globe"));
        model.settle();
        events();
        assertNotSame(before, model.state().pictures().software().orElseThrow());
    }

    @Test
    void missingLibraryIsToldOnceAndNobodyWaits() throws Exception {
        open(
                () -> {
                    throw new UnsatisfiedLinkError("libGL");
                });
        window.settle();
        events();
        assertTrue(unusable);
        assertEquals(0, place.getComponentCount());
    }

    @Test
    void modelsFirstPictureIsMadeWithoutTheWindow() throws Exception {
        open(this::slowCanvas);
        begun.await();
        events();
        assertTrue(model.state().pictures().software().isPresent());
        assumeTrue(model.state().report().isPresent(), "no OpenGL without a window");
        assertTrue(model.state().pictures().openGl().isPresent());
        mayGoOn.countDown();
        window.settle();
    }
}
