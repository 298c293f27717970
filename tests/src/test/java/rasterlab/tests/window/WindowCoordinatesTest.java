package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JList;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.list.ListChoice;
import rasterlab.app.coordinates.list.ListItem;
import rasterlab.app.coordinates.list.Reading;
import rasterlab.app.coordinates.list.Subject;
import rasterlab.app.coordinates.list.Trial;
import rasterlab.app.coordinates.stack.StackOp;
import rasterlab.app.coordinates.view.Stereoscopy;
import rasterlab.app.coordinates.view.ViewChoice;
import rasterlab.app.coordinates.view.ViewKind;
import rasterlab.app.coordinates.view.ViewNumber;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.tests.bench.window.WindowContent;

/** The window of the labs of coordinates under a real display, by mouse and keyboard. */
class WindowCoordinatesTest extends WindowHarness {
    @BeforeEach
    void showCoordinates() {
        if (window != null) show("coordinates");
    }

    private CoordinatesLabModel labs() {
        return models.of(new CoordinatesRoom());
    }

    private ViewChoice view() {
        return GuiActionRunner.execute(() -> labs().views().choice());
    }

    private ListChoice list() {
        return GuiActionRunner.execute(() -> labs().transformations().choice());
    }

    private void choose(CoordinatesMode mode) {
        window.comboBox("mode").selectItem(mode.ordinal());
        robot.waitForIdle();
        assertEquals(mode, labs().mode());
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
    void arrowKeysTurnTheHouseFromTheStart() {
        double before = view().numbers().get(ViewNumber.ANGLE_Y);
        press(KeyEvent.VK_RIGHT);
        assertTrue(view().numbers().get(ViewNumber.ANGLE_Y) > before);
        assertTrue(
                colors("handle.vertex").contains(StageColors.LIGHT.focus().getRGB()), "no focus");
        press(KeyEvent.VK_HOME);
        assertEquals(0, labs().views().step());
        press(KeyEvent.VK_PAGE_DOWN);
        assertEquals(1, labs().views().step());
    }

    @Test
    void draggedVertexTurnsTheHouseAndUndoBringsItBack() {
        ViewChoice before = view();
        drag("handle.vertex", 60, 20);
        assertNotEquals(before, view());
        window.button("undo").click();
        await("what was before is back", () -> view().equals(before));
    }

    @Test
    void draggedGroundTurnsASpaceWithDepth() {
        window.button("player.back").click();
        robot.waitForIdle();
        double alpha = view().viewpoint().alphaDegrees();
        Component stage = named("stage");
        robot.pressMouse(stage, new Point(40, 40), MouseButton.LEFT_BUTTON);
        robot.moveMouse(stage, new Point(80, 60));
        robot.releaseMouseButtons();
        robot.waitForIdle();
        assertEquals(alpha + 20, view().viewpoint().alphaDegrees(), 2);
    }

    @Test
    void everyControlOfAViewDoesSomething() {
        window.comboBox("kind").selectItem(ViewKind.SPHERICAL_LEFT.ordinal());
        window.slider("theta").slideTo(200);
        window.spinner("phi.field").enterTextAndCommit("55");
        robot.waitForIdle();
        assertNotEquals(30, view().numbers().get(ViewNumber.THETA));
        assertEquals(55, view().numbers().get(ViewNumber.PHI));
        window.slider("d").requireDisabled();
        window.comboBox("stereo").selectItem(Stereoscopy.ANAGLYPH.ordinal());
        await("two eyes", () -> colors("stage").contains(0xFFE02020));
        window.slider("separation").slideTo(100);
        window.checkBox("stable").click();
        robot.waitForIdle();
        window.slider("d").requireEnabled();
        await("one eye", () -> !colors("stage").contains(0xFFE02020));
        window.comboBox("stereo").requireDisabled();
        window.checkBox("vanishing").click();
        window.comboBox("vertex").selectItem(0);
        window.comboBox("method").selectItem("float");
        robot.waitForIdle();
        assertTrue(view().vanishing());
        assertEquals(1, view().vertex());
        assertEquals("float", view().method());
        window.button("chip.worked").click();
        robot.waitForIdle();
        assertEquals(ViewKind.HOUSE, view().kind());
    }

    @Test
    void pictureOfTheWindowHasItsYDownward() {
        press(KeyEvent.VK_END);
        await("the window's stage", () -> named("stage.down").isShowing());
        window.slider("width").slideTo(50);
        robot.waitForIdle();
        assertTrue(view().numbers().get(ViewNumber.WIDTH) < 400);
        int light = StageColors.LIGHT.focus().getRGB();
        focus("handle.vertex");
        assertTrue(colors("handle.vertex").contains(light), "no focus");
    }

    @Test
    void everyControlOfAListDoesSomething() {
        choose(CoordinatesMode.TRANSFORMATIONS);
        window.comboBox("reading").selectItem(Reading.FRAME.ordinal());
        window.comboBox("matrix").selectItem("SHEAR2D");
        window.button("add").click();
        robot.waitForIdle();
        assertEquals(4, list().items().size());
        assertEquals("SHEAR2D", list().items().get(list().selected()).name());
        window.spinner("number.0").enterTextAndCommit("1.5");
        robot.waitForIdle();
        assertEquals(1.5, list().items().get(list().selected()).numbers().get(0));
        window.button("earlier").click();
        window.button("later").click();
        window.button("remove").click();
        robot.waitForIdle();
        assertEquals(List.of("TRANSL2D", "ROT2D", "SCALE2D"), names());
        window.list("list").selectItem(0);
        robot.waitForIdle();
        assertEquals(0, list().selected());
        window.comboBox("subject").selectItem(Subject.HOUSE.ordinal());
        window.comboBox("example").selectItem(0);
        robot.waitForIdle();
        assertEquals(Subject.SQUARE, list().subject());
        window.comboBox("method").selectItem("formula-textbook");
        robot.waitForIdle();
        assertEquals("formula-textbook", list().method());
    }

    private List<String> names() {
        return list().items().stream().map(ListItem::name).toList();
    }

    @Test
    void draggedCornerMovesAloneAndPrintedMatricesAreMarked() {
        choose(CoordinatesMode.TRANSFORMATIONS);
        List<Double> before = list().points();
        drag("corner.2", 40, -40);
        assertNotEquals(before.get(4), list().points().get(4));
        assertEquals(before.subList(0, 4), list().points().subList(0, 4));
        int wrong = MethodColors.VERMILLION.getRGB();
        assertFalse(colors("stage").contains(wrong), "marked unasked");
        window.button("chip.axis").click();
        await("the printed matrix is marked", () -> colors("stage").contains(wrong));
    }

    @Test
    void hazardOfPointsIsTriedByTheChosenMethodUntilTheListIsChanged() {
        choose(CoordinatesMode.TRANSFORMATIONS);
        window.comboBox("topic").selectItem("turn about a line");
        window.button("chip.axis-along-x").click();
        window.comboBox("method").selectItem("seven-steps-textbook");
        await("the method's verdict is said", () -> verdict().equals("wrong"));
        window.comboBox("method").selectItem("rodrigues");
        await("another method is tried", () -> verdict().equals("exact"));
        assertEquals(
                Optional.of(new Trial("rotate-axis", "axis-along-x", "rodrigues")), list().trial());
        window.button("undo").click();
        await("the method before is back", () -> verdict().equals("wrong"));
        window.button("remove").click();
        robot.waitForIdle();
        assertEquals(Optional.empty(), list().trial());
        window.button("chip.axis").requireVisible();
    }

    private String verdict() {
        return window.label("trial.verdict.value").text();
    }

    @Test
    void stackIsPushedAndPoppedUntilItIsEmpty() {
        choose(CoordinatesMode.STACK);
        window.button("clear").click();
        window.button("push").click();
        window.button("identity").click();
        window.button("pop").click();
        window.button("pop").click();
        robot.waitForIdle();
        JList<?> program = window.list("program").target();
        String last = GuiActionRunner.execute(() -> program.getModel().getElementAt(3).toString());
        assertTrue(last.startsWith("✗"), last);
        window.comboBox("command").selectItem(StackOp.TRANSLATE.ordinal());
        window.button("add").click();
        window.spinner("number.1").enterTextAndCommit("3");
        robot.waitForIdle();
        var commands = labs().stack().choice().commands();
        assertEquals(3, commands.get(4).numbers().get(1));
        window.button("remove").click();
        window.list("program").selectItem(0);
        robot.waitForIdle();
        assertEquals(1, labs().stack().step());
        window.button("chip.arm").click();
        drag("turn", 30, 10);
        assertNotEquals(-32, labs().stack().choice().viewpoint().alphaDegrees());
    }

    @Test
    void everyControlOfRotationDoesSomething() {
        choose(CoordinatesMode.ROTATION);
        int own = LabRooms.card("rotate").colors().of("table").getRGB();
        window.comboBox("method").selectItem("table");
        await("the way is drawn", () -> colors("stage").contains(own));
        int line =
                MethodColors.edgeOn(
                                StageColors.LIGHT.ground(),
                                LabRooms.card("rotate").colors().of("table"))
                        .getRGB();
        await("the drift is drawn", () -> colors("stage.chart").contains(line));
        window.spinner("degrees.field").enterTextAndCommit("12.5");
        window.slider("times").slideTo(100);
        window.spinner("point.x").enterTextAndCommit("5");
        robot.waitForIdle();
        var choice = labs().rotation().choice();
        assertEquals(12.5, choice.degrees());
        assertTrue(choice.times() > 7);
        assertEquals(5, choice.x());
        focus("handle.point");
        press(KeyEvent.VK_UP);
        assertTrue(labs().rotation().choice().y() > 3);
        window.button("chip.half-turn").click();
        robot.waitForIdle();
        assertEquals(180, labs().rotation().choice().degrees());
    }

    @ParameterizedTest(name = "another lab is shown after a change of language: {0}")
    @EnumSource(CoordinatesMode.class)
    void languageKeepsTheLab(CoordinatesMode mode) {
        choose(mode);
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals("coordinates", WindowContent.of(frame).shown());
        assertEquals(mode, labs().mode());
        window.comboBox("mode").requireSelection(mode.ordinal());
    }
}
