package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;

@Timeout(300)
class LineStageViewTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LineLabModel model =
            new LineLabModel(new LineTopic(), Runnable::run, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** A stage of 600 × 400 that follows the model. */
    private LineStage stage() {
        var stage = new LineStage(model, Texts.of("line", Language.ENGLISH), failures::add);
        stage.setSize(600, 400);
        laidOut(stage);
        return stage;
    }

    private static void laidOut(LineStage stage) {
        stage.refresh();
        stage.doLayout();
    }

    private void drag(LineStage stage, String end, int right, int down) {
        Component handle = named(stage, end);
        var middle = new Point(handle.getWidth() / 2, handle.getHeight() / 2);
        Point at = handle.getLocation();
        press(handle, MouseEvent.MOUSE_PRESSED, middle);
        for (int part = 1; part <= 5; part++) {
            int x = at.x + middle.x + right * part / 5 - handle.getX();
            int y = at.y + middle.y + down * part / 5 - handle.getY();
            press(handle, MouseEvent.MOUSE_DRAGGED, new Point(x, y));
            laidOut(stage);
        }
        press(handle, MouseEvent.MOUSE_RELEASED, middle);
        laidOut(stage);
    }

    @Test
    @DisplayName("the picture moves while an end is dragged, when it is dropped, or by undo")
    void theGridStaysWhenAnEndIsDraggedDroppedAndPutBack() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model.show(new Segment(0, 0, 11, 4));
                    try (LineStage stage = stage()) {
                        Rectangle a = named(stage, "end.A").getBounds();
                        Rectangle b = named(stage, "end.B").getBounds();
                        drag(stage, "end.B", 0, 110);
                        assertTrue(model.state().choice().segment().y1() > 6, "dragged down");
                        assertEquals(a, named(stage, "end.A").getBounds(), "dropped");
                        model.history().undo();
                        laidOut(stage);
                        assertEquals(a, named(stage, "end.A").getBounds(), "undone");
                        assertEquals(b, named(stage, "end.B").getBounds(), "undone");
                    }
                });
    }

    @Test
    @DisplayName("undo leaves a hazard's view around another segment")
    void undoOfAHazardShowsTheSegmentBefore() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model.show(new Segment(0, 0, 11, 4));
                    try (LineStage stage = stage()) {
                        Rectangle before = named(stage, "end.A").getBounds();
                        model.show(new Segment(5_000, 5_000, 5_003, 5_001));
                        laidOut(stage);
                        model.history().undo();
                        laidOut(stage);
                        assertEquals(before, named(stage, "end.A").getBounds());
                    }
                });
    }

    @Test
    void endThatLeavesTheSightByKeysIsShown() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model.show(new Segment(0, 0, 11, 4));
                    try (LineStage stage = stage()) {
                        Rectangle before = named(stage, "end.A").getBounds();
                        model.nudgeEnd(End.B, 1, 0);
                        laidOut(stage);
                        assertEquals(before, named(stage, "end.A").getBounds(), "a step aside");
                        model.nudgeEnd(End.B, 100, 0);
                        laidOut(stage);
                        Component end = named(stage, "end.B");
                        assertTrue(stage.getBounds().contains(end.getBounds()));
                        assertFalse(before.equals(named(stage, "end.A").getBounds()));
                    }
                });
    }

    @Test
    @DisplayName("the ring of an end out of sight lies at a pixel that is not the end's")
    void endOutOfSightIsAnArrowThatIsNotDragged() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model.show(new Segment(0, 0, 11, 4));
                    try (LineStage stage = stage()) {
                        Component end = named(stage, "end.B");
                        BufferedImage ring = painted(end);
                        drag(stage, "end.B", 900, 0);
                        Segment away = model.state().choice().segment();
                        assertTrue(away.x1() > 15, away.toString());
                        assertTrue(solid(painted(end)) > 3 * solid(ring), "still a ring");
                        drag(stage, "end.B", -200, 40);
                        assertEquals(away, model.state().choice().segment(), "dragged from there");
                        press(end, MouseEvent.MOUSE_CLICKED, new Point(9, 9));
                        laidOut(stage);
                        assertTrue(solid(painted(end)) < 2 * solid(ring), "not shown by a click");
                    }
                });
    }

    private static BufferedImage painted(Component handle) {
        var image = new BufferedImage(40, 40, BufferedImage.TYPE_INT_ARGB);
        handle.setSize(26, 26);
        handle.paint(image.createGraphics());
        return image;
    }

    /** Dots of ink in the middle, which a ring leaves free. */
    private static int solid(BufferedImage handle) {
        int count = 1;
        for (int x = 9; x < 17; x++)
            for (int y = 9; y < 17; y++)
                if (handle.getRGB(x, y) == StageColors.LIGHT.ink().getRGB()) count++;
        return count;
    }

    private static Component named(Container in, String name) {
        return Stream.of(in.getComponents())
                .filter(one -> name.equals(one.getName()))
                .findFirst()
                .orElseThrow();
    }

    private static void press(Component target, int kind, Point at) {
        target.dispatchEvent(
                new MouseEvent(target, kind, 0, 0, at.x, at.y, 1, false, MouseEvent.BUTTON1));
    }
}
