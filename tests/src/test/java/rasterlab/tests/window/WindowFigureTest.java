package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.line.figure.ArcFigure;
import rasterlab.app.line.figure.Dashes;
import rasterlab.app.line.figure.FigureState;
import rasterlab.app.line.figure.PenFigure;
import rasterlab.app.line.figure.SlopeFigure;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.rooms.LabRooms;

/** Circles, ellipses, pens and the chart of brightness under a real display. */
class WindowFigureTest extends WindowHarness {
    @BeforeEach
    void showLines() {
        if (window != null) show("line");
    }

    private FigureState state() {
        return GuiActionRunner.execute(() -> models.of(new LineRoom()).figures().state());
    }

    private <F> F figure(Class<F> kind) {
        return kind.cast(state().scene().figure());
    }

    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
    }

    private void choose(LineMode mode) {
        window.comboBox("mode").selectItem(mode.ordinal());
        await("the mode's figure", () -> state().drawn().mode() == mode);
        robot.waitForIdle();
    }

    private void drag(String name, int right, int down) {
        Component handle = named(name);
        var center = new Point(handle.getWidth() / 2, handle.getHeight() / 2);
        robot.pressMouse(handle, center, MouseButton.LEFT_BUTTON);
        robot.moveMouse(handle, center.x + right / 2, center.y + down / 2);
        robot.moveMouse(named(name), center.x + right / 2, center.y + down / 2);
        robot.releaseMouseButtons();
        robot.waitForIdle();
    }

    @Test
    void draggedRadiusAndCenterChangeTheCircle() {
        choose(LineMode.CIRCLE);
        ArcFigure before = figure(ArcFigure.class);
        drag("grip.radiusX", -80, 0);
        assertTrue(figure(ArcFigure.class).radiusX() < before.radiusX());
        focus("grip.centre");
        press(KeyEvent.VK_RIGHT);
        assertEquals(before.centerX() + 1, figure(ArcFigure.class).centerX());
        window.button("undo").click();
        window.button("undo").click();
        await("what was before is back", () -> figure(ArcFigure.class).equals(before));
    }

    @Test
    void stepsByKeysAndMarksWrongPixelsAtTheEnd() {
        choose(LineMode.ELLIPSE);
        window.comboBox("method").selectItem("parametric");
        window.button("chip.corner").click();
        await("wrong pixels are marked", this::isMarked);
        focus("grip.centre");
        press(KeyEvent.VK_HOME);
        await("one pixel is lit", () -> !isMarked());
        press(KeyEvent.VK_PAGE_DOWN);
        assertEquals(2, state().step());
        press(KeyEvent.VK_END);
        await("all are lit", this::isMarked);
    }

    /** The lines of a mark are thin, and so mixed with what is under them. */
    private boolean isMarked() {
        Color mark = MethodColors.VERMILLION;
        return colors("stage").stream()
                .map(Color::new)
                .anyMatch(
                        each ->
                                Math.abs(each.getRed() - mark.getRed()) < 32
                                        && Math.abs(each.getGreen() - mark.getGreen()) < 32
                                        && Math.abs(each.getBlue() - mark.getBlue()) < 32);
    }

    @Test
    void secondMethodHasAPictureOfItsOwn() {
        choose(LineMode.CIRCLE);
        window.comboBox("comparison").selectItem("parametric");
        await("a second picture", () -> named("stage.other").getHeight() > 100);
        int second = LabRooms.card("circle").colors().of("parametric").getRGB();
        await("its pixels", () -> colors("stage.other").contains(second));
    }

    @Test
    void penIsChosenAndItsPointsMoved() {
        choose(LineMode.PEN);
        PenFigure before = figure(PenFigure.class);
        window.comboBox("dashes").selectItem(Dashes.DASHED.ordinal());
        window.checkBox("round").click();
        window.slider("width").slideToMaximum();
        robot.waitForIdle();
        PenFigure changed = figure(PenFigure.class);
        assertEquals(Dashes.DASHED, changed.dashes());
        assertFalse(changed.round());
        assertEquals(12, changed.width());
        focus("point.1");
        press(KeyEvent.VK_UP);
        assertTrue(figure(PenFigure.class).points().get(1).y() < before.points().get(1).y());
        press(KeyEvent.VK_DELETE);
        assertEquals(before.points().size() - 1, figure(PenFigure.class).points().size());
    }

    @Test
    void timelineIsThereOnlyWhereThereAreSteps() {
        choose(LineMode.CIRCLE);
        assertTrue(isSeen("player.play"), "no timeline");
        choose(LineMode.BRIGHTNESS);
        assertFalse(isSeen("player.play"), "a timeline without steps");
        choose(LineMode.PEN);
        assertFalse(isSeen("player.play"), "a timeline of no steps for a pen");
        choose(LineMode.ELLIPSE);
        assertTrue(isSeen("player.play"), "the timeline does not come back");
    }

    @Test
    void angleIsReadOffTheChart() {
        choose(LineMode.BRIGHTNESS);
        focus("grip.angle");
        press(KeyEvent.VK_RIGHT);
        assertTrue(figure(SlopeFigure.class).degrees() > 30);
        String light = window.label("light.value").text();
        press(KeyEvent.VK_RIGHT);
        await("another number", () -> !window.label("light.value").text().equals(light));
    }

    @Test
    void languageKeepsTheModeAndTheSegmentComesBack() {
        choose(LineMode.CIRCLE);
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals(
                LineMode.CIRCLE, GuiActionRunner.execute(() -> models.of(new LineRoom()).mode()));
        window.comboBox("mode").selectItem(LineMode.SEGMENT.ordinal());
        robot.waitForIdle();
        int before = segment().x0();
        press(KeyEvent.VK_RIGHT);
        assertEquals(before + 1, segment().x0());
    }
}
