package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.lwjgl.opengl.GL11;
import rasterlab.app.opengl.state.Setting;

/** OpenGL's window with what it keeps; skipped without a display or without OpenGL on it. */
class GlCanvasTest {
    /** OpenGL's names of textures and lists are counted from 1; this is far beyond what is kept. */
    private static final int MOST_NAMES = 1000;

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private OpenGlLabModel model;
    private JFrame frame;
    private GlCanvas canvas;
    private boolean unusable;
    private volatile long objects;
    private final List<Long> destroyed = new CopyOnWriteArrayList<>();

    /** Keeps which contexts were given back, and how many objects OpenGL keeps for the last one. */
    private final class Recorded extends GlCanvas {
        private static final long serialVersionUID = 1L;

        Recorded() {
            super(model, () -> unusable = true);
        }

        @Override
        public void paintGL() {
            super.paintGL();
            objects =
                    IntStream.rangeClosed(1, MOST_NAMES).filter(GL11::glIsTexture).count()
                            + IntStream.rangeClosed(1, MOST_NAMES).filter(GL11::glIsList).count();
        }

        @Override
        void destroy(long ended) {
            destroyed.add(ended);
            objects = 0;
            super.destroy(ended);
        }
    }

    @BeforeEach
    void open() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        EventQueue.invokeAndWait(
                () -> {
                    model = new OpenGlLabModel(EventQueue::invokeLater, failures::add);
                    model.attach();
                    model.resize(200, 150);
                    model.set(Setting.SCENE, "globe");
                    model.set(Setting.DISPLAY_LIST, "on");
                    canvas = new Recorded();
                    frame = new JFrame();
                    // Another process may test keys on this display.
                    frame.setFocusableWindowState(false);
                    frame.setSize(200, 150);
                    frame.add(canvas, BorderLayout.CENTER);
                    frame.setVisible(true);
                });
        draw();
        assumeFalse(unusable, "no OpenGL on this display");
        assumeTrue(canvas.hasContext(), "the window is not shown");
    }

    @AfterEach
    void close() throws Exception {
        if (frame == null) return;
        EventQueue.invokeAndWait(frame::dispose);
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Context, what it can and picture are an event each. */
    private void draw() throws Exception {
        EventQueue.invokeAndWait(canvas::ask);
        for (int step = 0; step < 3; step++) EventQueue.invokeAndWait(() -> {});
    }

    @Test
    void windowThatGoesGivesEverythingBack() throws Exception {
        assertTrue(objects >= 2, "a texture and a list");
        EventQueue.invokeAndWait(() -> frame.remove(canvas));
        assertFalse(canvas.hasContext());
        assertEquals(1, destroyed.size(), "contexts");
    }

    @Test
    void sizeThatIsToldWhenTheWindowIsGoneHarmsNothing() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    frame.remove(canvas);
                    canvas.dispatchEvent(
                            new ComponentEvent(canvas, ComponentEvent.COMPONENT_RESIZED));
                });
    }

    @Test
    void contextIsMadeAgainWhenTheWindowComesBack() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    frame.remove(canvas);
                    frame.add(canvas, BorderLayout.CENTER);
                    frame.validate();
                });
        draw();
        assertTrue(canvas.hasContext());
        assertTrue(objects >= 2, "uploaded again");
        assertFalse(unusable);
    }

    @Test
    void windowThatGoesBetweenContextAndPictureGivesTheContextBack() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    frame.remove(canvas);
                    frame.add(canvas, BorderLayout.CENTER);
                    frame.validate();
                    canvas.update(canvas.getGraphics());
                    assertTrue(canvas.hasContext(), "the first step");
                    frame.remove(canvas);
                });
        draw();
        assertFalse(canvas.hasContext());
        assertEquals(0, objects);
        contextIsMadeAgainWhenTheWindowComesBack();
    }

    @Test
    void pictureThatFailsOnceIsDrawnInANewContext() throws Exception {
        failNext(1);
        draw();
        assertFalse(unusable);
        assertTrue(objects >= 2, "uploaded again");
        assertEquals(1, destroyed.size(), "contexts");
    }

    @Test
    void pictureThatFailsTwiceEndsTheWindow() throws Exception {
        failNext(2);
        assertTrue(unusable);
        assertFalse(canvas.hasContext());
    }

    /** Draws while so many of the next pictures fail on their way to the model. */
    private void failNext(int pictures) throws Exception {
        model.settle();
        EventQueue.invokeAndWait(() -> {});
        var left = new AtomicInteger(pictures);
        EventQueue.invokeAndWait(
                () ->
                        model.listen(
                                state -> {
                                    if (isDrawn() && left.getAndDecrement() > 0)
                                        throw new IllegalStateException("the context is lost");
                                }));
        while (!unusable && left.get() > 0) draw();
    }

    /** Answers of the model's own thread come at any time, and are no failures of the window. */
    private static boolean isDrawn() {
        String window = GlCanvas.class.getName();
        return StackWalker.getInstance()
                .walk(frames -> frames.anyMatch(each -> each.getClassName().equals(window)));
    }

    @Test
    void manyFramesKeepNoMoreObjects() throws Exception {
        for (String size : Setting.SIZE.options())
            for (String components : Setting.COMPONENTS.options())
                for (String image : List.of("map", "checker", "waves")) {
                    EventQueue.invokeAndWait(
                            () -> {
                                model.set(Setting.SIZE, size);
                                model.set(Setting.COMPONENTS, components);
                                model.set(Setting.IMAGE, image);
                            });
                    draw();
                }
        assertTrue(objects <= 30, objects + " objects");
    }
}
