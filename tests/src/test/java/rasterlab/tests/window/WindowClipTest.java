package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.clip.ClipChoice;
import rasterlab.app.clip.ClipLabState;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.tests.bench.window.WindowContent;

/** The clipping lab's window under a real display, by mouse and keyboard. */
class WindowClipTest extends WindowHarness {
    @BeforeEach
    void showClipping() {
        if (window != null) show("clip");
    }

    private ClipLabState state() {
        return GuiActionRunner.execute(() -> models.of(new ClipRoom()).state());
    }

    private ClipChoice choice() {
        return state().choice();
    }

    private ClipPoint end(int segment, int end) {
        var found = choice().segments().segments().get(segment);
        return end == 0 ? found.a() : found.b();
    }

    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
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
    void draggedCornerOfTheWindowChangesWhatIsLeft() {
        ClipChoice before = choice();
        drag("window.3", -80, 60);
        ClipPoint corner = choice().segments().window().corners().get(2);
        assertTrue(corner.x() < 10 && corner.y() < 6, corner.toString());
        assertEquals(new ClipPoint(0, 0), choice().segments().window().corners().get(0));
        await(
                "the answer is that of the new window",
                () -> state().results().scene().equals(choice().scene()));
        window.button("undo").click();
        await("what was before is back", () -> choice().equals(before));
    }

    @Test
    void draggedEndMovesAlone() {
        ClipPoint other = end(0, 1);
        ClipPoint before = end(0, 0);
        drag("end.A1", 40, -40);
        assertNotEquals(before, end(0, 0));
        assertEquals(other, end(0, 1));
    }

    @Test
    void arrowKeysMoveThePointThatHasTheKeyboard() {
        focus("end.B2");
        ClipPoint before = end(1, 1);
        press(KeyEvent.VK_LEFT);
        assertTrue(end(1, 1).x() < before.x());
        assertEquals(before.y(), end(1, 1).y());
        assertTrue(colors("end.B2").contains(StageColors.LIGHT.focus().getRGB()), "no focus");
        assertEquals("B2", state().selected().label());
    }

    @Test
    void stepsByKeysAndShowsTheResultInTheMethodsColor() {
        int left = LabRooms.card("clip-segment").colors().of("cohen-sutherland").getRGB();
        await("the result is drawn", () -> colors("stage").contains(left));
        focus("end.A1");
        press(KeyEvent.VK_HOME);
        await("nothing is clipped yet", () -> !colors("stage").contains(left));
        press(KeyEvent.VK_PAGE_DOWN);
        assertEquals(1, models.of(new ClipRoom()).step());
        press(KeyEvent.VK_END);
        await("the result is drawn again", () -> colors("stage").contains(left));
    }

    @Test
    void secondMethodHasAPictureOfItsOwnUntilTheDifferenceIsShown() {
        window.comboBox("comparison").selectItem("cohen-sutherland-textbook");
        await("a second picture", () -> named("stage.other").getHeight() > 100);
        int wrong = MethodColors.VERMILLION.getRGB();
        await("wrong parts are marked", () -> colors("stage.other").contains(wrong));
        assertFalse(colors("stage").contains(wrong), "marked where nothing is wrong");
        window.checkBox("difference").click();
        await("one picture", () -> !frameHas("stage.other"));
        assertTrue(choice().difference());
    }

    private boolean frameHas(String name) {
        return !window.robot()
                .finder()
                .findAll(frame, found -> name.equals(found.getName()) && found.isShowing())
                .isEmpty();
    }

    @Test
    void hazardsBelongToTheMode() {
        window.comboBox("mode").selectItem(ClipMode.POLYGON.ordinal());
        window.button("chip.comb").click();
        await("the comb", () -> choice().polygon().subject().size() == 12);
        assertFalse(frameHas("chip.only-left"), "a chip of another mode");
        window.comboBox("method").selectItem("weiler-atherton");
        await("three pieces", () -> state().results().clipping().parts().size() == 3);
    }

    @Test
    void draggedGroundTurnsTheViewVolumeAndArrowsMoveItsEnds() {
        window.comboBox("mode").selectItem(ClipMode.VOLUME.ordinal());
        robot.waitForIdle();
        double alpha = choice().volume().view().alphaDegrees();
        Component stage = named("stage");
        robot.pressMouse(stage, new Point(40, 40), MouseButton.LEFT_BUTTON);
        robot.moveMouse(stage, new Point(80, 60));
        robot.releaseMouseButtons();
        robot.waitForIdle();
        assertEquals(alpha - 20, choice().volume().view().alphaDegrees(), 2);
        focus("end.B1");
        SpacePoint before = choice().volume().segments().get(0).b();
        press(KeyEvent.VK_UP);
        assertTrue(choice().volume().segments().get(0).b().y() > before.y());
        window.button("undo").click();
        window.button("undo").click();
        robot.waitForIdle();
        assertEquals(alpha, choice().volume().view().alphaDegrees(), 1e-9);
    }

    @Test
    void languageKeepsTheSceneAndTheMode() {
        window.comboBox("mode").selectItem(ClipMode.VOLUME.ordinal());
        robot.waitForIdle();
        ClipChoice before = choice();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals("clip", WindowContent.of(frame).shown());
        assertEquals(before, choice());
    }
}
