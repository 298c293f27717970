package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.CurveLabModel;
import rasterlab.app.spline.FunctionLabModel;
import rasterlab.app.spline.Place;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;

/** The tab of splines in a real window, by mouse and keyboard. */
class SplineWindowTest extends WindowHarness {
    @BeforeEach
    void showSplines() {
        show("spline");
    }

    @Test
    void dragMovesAPointAndUndoBringsItBack() {
        List<Place> before = points();
        drag("point.1", 80, 60);
        List<Place> after = points();
        assertTrue(after.get(1).x() > before.get(1).x() + 20, after.toString());
        assertTrue(after.get(1).y() > before.get(1).y() + 20, after.toString());
        assertEquals(before.get(2), after.get(2));
        window.button("undo").click();
        await("what was before is back", () -> points().equals(before));
    }

    @Test
    void draggedPointStaysUnderThePointer() {
        Point from = GuiActionRunner.execute(() -> middle("point.2"));
        drag("point.2", -70, 90);
        Point to = GuiActionRunner.execute(() -> middle("point.2"));
        assertEquals(-70, to.x - from.x, 2);
        assertEquals(90, to.y - from.y, 2);
    }

    @Test
    void arrowsMoveThePointWithTheKeysAndShiftMovesFar() {
        Place before = points().get(0);
        focus("point.0");
        press(KeyEvent.VK_RIGHT);
        Place near = points().get(0);
        assertTrue(near.x() > before.x(), near.toString());
        assertEquals(before.y(), near.y());
        robot.pressKey(KeyEvent.VK_SHIFT);
        press(KeyEvent.VK_UP);
        robot.releaseKey(KeyEvent.VK_SHIFT);
        robot.waitForIdle();
        assertEquals(10 * (near.x() - before.x()), before.y() - points().get(0).y(), 1e-6);
    }

    @Test
    void twoClicksAddAPointAndDeleteTakesItAway() {
        List<Place> before = points();
        Component stage = window.robot().finder().findByName(frame, "stage");
        robot.click(stage, new Point(stage.getWidth() - 60, 60), MouseButton.LEFT_BUTTON, 2);
        robot.waitForIdle();
        assertEquals(5, points().size());
        press(KeyEvent.VK_DELETE);
        assertEquals(before, points(), "the added point had the keyboard");
        press(KeyEvent.VK_RIGHT);
        await("the keys go to the last point", () -> points().get(3).x() != 600);
    }

    @Test
    void wheelZoomsAboutThePointerAndZeroShowsAllAgain() {
        Component stage = window.robot().finder().findByName(frame, "stage");
        Point before = GuiActionRunner.execute(() -> middle("point.3"));
        robot.moveMouse(stage, new Point(200, 200));
        robot.rotateMouseWheel(stage, -2);
        robot.waitForIdle();
        Point zoomed = GuiActionRunner.execute(() -> middle("point.3"));
        assertNotEquals(before, zoomed);
        focus("point.0");
        robot.type('0');
        await(
                "all is shown",
                () -> GuiActionRunner.execute(() -> middle("point.3")).equals(before));
    }

    @Test
    void playerLeadsTAlongTheCurve() {
        window.button("player.toStart").click();
        robot.waitForIdle();
        assertEquals(0, GuiActionRunner.execute(() -> curve().state().t()));
        window.button("player.toEnd").click();
        robot.waitForIdle();
        assertEquals(1, GuiActionRunner.execute(() -> curve().state().t()));
    }

    @Test
    void hazardsChipShowsWhereTheNaiveMethodFails() {
        window.comboBox("method").selectItem("adaptive-naive");
        window.button("chip.s-curve").click();
        int orange = LabRooms.card("curve").colors().of("adaptive-naive").getRGB();
        await("the naive chord is drawn", () -> GuiActionRunner.execute(() -> curve().last()) == 1);
        window.button("player.toEnd").click();
        await("in its colour", () -> colors("stage").contains(orange));
    }

    @Test
    void otherLabIsChosenAndItsKnotsAreMoved() {
        window.comboBox("mode").selectItem(1);
        robot.waitForIdle();
        assertEquals(
                SplineMode.FUNCTION,
                GuiActionRunner.execute(() -> models.of(new SplineRoom()).mode()));
        Place before = knots().get(3);
        drag("point.3", 0, -40);
        assertTrue(knots().get(3).y() > before.y(), "y grows upward: " + knots());
        window.comboBox("ends").selectItem(0);
        robot.waitForIdle();
        drag("slope.left", 0, -50);
        assertTrue(function().state().choice().ends().left() < 0, "" + function().state());
        window.comboBox("mode").selectItem(0);
        robot.waitForIdle();
        window.comboBox("form").requireVisible();
    }

    @ParameterizedTest(name = "a point is out of sight in {0}×{1}")
    @CsvSource({"900, 600", "1280, 800", "2560, 1440"})
    void everyFormIsInSightInEverySize(int width, int height) {
        window.resizeTo(new Dimension(width, height));
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        for (CurveForm form : CurveForm.values()) {
            GuiActionRunner.execute(() -> curve().chooseForm(form));
            robot.waitForIdle();
            Component stage = window.robot().finder().findByName(frame, "stage");
            for (int i = 0; i < points().size(); i++) {
                String name = "point." + i;
                Point middle = GuiActionRunner.execute(() -> middle(name));
                assertTrue(
                        middle.x > 44
                                && middle.y > 22
                                && middle.x < stage.getWidth()
                                && middle.y < stage.getHeight(),
                        form + " " + name + ": " + middle);
            }
        }
    }

    private CurveLabModel curve() {
        return models.of(new SplineRoom()).curve();
    }

    private FunctionLabModel function() {
        return models.of(new SplineRoom()).function();
    }

    private List<Place> points() {
        return GuiActionRunner.execute(() -> curve().state().choice().points());
    }

    private List<Place> knots() {
        return GuiActionRunner.execute(() -> function().state().choice().knots());
    }

    private void drag(String name, int dx, int dy) {
        Component handle = window.robot().finder().findByName(frame, name);
        var center = new Point(handle.getWidth() / 2, handle.getHeight() / 2);
        Point screen = handle.getLocationOnScreen();
        robot.pressMouse(handle, center, MouseButton.LEFT_BUTTON);
        var start = new Point(screen.x + center.x, screen.y + center.y);
        robot.moveMouse(new Point(start.x + dx / 2, start.y + dy / 2));
        robot.moveMouse(new Point(start.x + dx, start.y + dy));
        robot.releaseMouseButtons();
        robot.waitForIdle();
    }

    private Point middle(String name) {
        Component handle = window.robot().finder().findByName(frame, name);
        return new Point(
                handle.getX() + handle.getWidth() / 2, handle.getY() + handle.getHeight() / 2);
    }
}
