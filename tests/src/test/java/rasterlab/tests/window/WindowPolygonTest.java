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
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Language;
import rasterlab.app.polygon.PolygonChoice;
import rasterlab.app.polygon.PolygonLabState;
import rasterlab.app.polygon.PolygonRoom;
import rasterlab.app.polygon.figure.BrushKind;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.contract.FillRule;
import rasterlab.tests.bench.window.WindowContent;

/** The lab of polygons under a real display, by mouse and keyboard. */
class WindowPolygonTest extends WindowHarness {
    @BeforeEach
    void showPolygons() {
        if (window != null) show("polygon");
    }

    private PolygonLabState state() {
        return GuiActionRunner.execute(() -> models.of(new PolygonRoom()).state());
    }

    private PolygonChoice choice() {
        return state().choice();
    }

    private <F> F figure(Class<F> kind) {
        return kind.cast(choice().scene().figure());
    }

    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
    }

    private void choose(PolygonMode mode) {
        window.comboBox("mode").selectItem(mode.ordinal());
        await("the mode's answer", () -> state().results().scene().mode() == mode);
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
    void draggedCornerChangesTheFieldAndUndoBringsItBack() {
        PolygonChoice before = choice();
        drag("corner.1", -120, -60);
        PolygonPoint corner = figure(InsideFigure.class).corners().get(1);
        assertTrue(corner.x() < 10 && corner.y() > 1, corner.toString());
        await(
                "the answer is that of the new triangle",
                () -> state().results().scene().equals(choice().scene()));
        window.button("undo").click();
        await("what was before is back", () -> choice().equals(before));
    }

    @Test
    void wrongPointsOfThePlaneAreMarkedUntilAnExactMethodIsChosen() {
        int wrong = MethodColors.VERMILLION.getRGB();
        window.comboBox("method").selectItem("sign-double");
        drag("point", 60, 60);
        await("boundary points are marked", () -> colors("stage").contains(wrong));
        window.comboBox("method").selectItem("robust");
        await("nothing is wrong", () -> !colors("stage").contains(wrong));
    }

    @Test
    void arrowKeysMoveThePointAndWholeNumbersMakeItSnap() {
        focus("point");
        PolygonPoint before = figure(InsideFigure.class).points().get(0);
        press(KeyEvent.VK_RIGHT);
        PolygonPoint moved = figure(InsideFigure.class).points().get(0);
        assertTrue(moved.x() > before.x() && moved.x() < before.x() + 1, moved.toString());
        window.checkBox("whole").click();
        focus("point");
        press(KeyEvent.VK_RIGHT);
        PolygonPoint whole = figure(InsideFigure.class).points().get(0);
        assertEquals(Math.rint(whole.x()), whole.x());
        assertTrue(whole.x() > moved.x(), whole.toString());
    }

    @Test
    void cornersAreAddedAndRemoved() {
        choose(PolygonMode.TRIANGULATION);
        int corners = figure(CutFigure.class).corners().size();
        focus("corner.2");
        window.button("grow").click();
        robot.waitForIdle();
        assertEquals(corners + 1, figure(CutFigure.class).corners().size());
        focus("corner.3");
        press(KeyEvent.VK_DELETE);
        assertEquals(corners, figure(CutFigure.class).corners().size());
        window.button("shrink").click();
        robot.waitForIdle();
        assertEquals(corners - 1, figure(CutFigure.class).corners().size());
    }

    @Test
    void stepsByKeysCutOneTriangleAfterAnother() {
        choose(PolygonMode.TRIANGULATION);
        focus("corner.0");
        press(KeyEvent.VK_HOME);
        assertEquals(0, state().step());
        press(KeyEvent.VK_PAGE_DOWN);
        press(KeyEvent.VK_PAGE_DOWN);
        assertEquals(2, state().step());
        press(KeyEvent.VK_PAGE_UP);
        assertEquals(1, state().step());
        press(KeyEvent.VK_END);
        assertTrue(state().finished());
    }

    @Test
    void secondMethodHasAPictureOfItsOwnUntilTheDifferenceIsShown() {
        choose(PolygonMode.FILL);
        window.comboBox("method").selectItem("naive");
        window.comboBox("comparison").selectItem("edge-function");
        await("a second picture", () -> named("stage.other").getHeight() > 100);
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
    void ruleAndBrushAreChosen() {
        choose(PolygonMode.FILL);
        window.comboBox("rule").selectItem(FillRule.NON_ZERO.ordinal());
        window.comboBox("brush").selectItem(BrushKind.BRICKS.ordinal());
        assertEquals(FillRule.NON_ZERO, figure(FillFigure.class).rule());
        assertEquals(BrushKind.BRICKS, figure(FillFigure.class).brush());
    }

    @Test
    void wallsSeedAndNeighboursChangeWhatIsFilled() {
        choose(PolygonMode.SEED);
        focus("seed");
        PolygonPoint before = figure(SeedFigure.class).seed();
        press(KeyEvent.VK_RIGHT);
        assertEquals(new PolygonPoint(before.x() + 1, before.y()), figure(SeedFigure.class).seed());
        PolygonPoint pen = figure(SeedFigure.class).pen();
        int row = (int) pen.y();
        window.button("wall").click();
        robot.waitForIdle();
        assertEquals('#', figure(SeedFigure.class).rows().get(row).charAt((int) pen.x()));
        window.button("clear").click();
        robot.waitForIdle();
        assertEquals('.', figure(SeedFigure.class).rows().get(row).charAt((int) pen.x()));
        window.comboBox("connectivity").selectItem(1);
        assertEquals(8, figure(SeedFigure.class).connectivity());
        window.comboBox("colour").selectItem(1);
        assertTrue(figure(SeedFigure.class).same());
    }

    @Test
    void hazardsBelongToTheMode() {
        choose(PolygonMode.POLYGON);
        window.button("chip.covered-twice").click();
        await("the star", () -> figure(InsideFigure.class).corners().size() == 5);
        assertFalse(frameHas("chip.minus-zero"), "a chip of another mode");
        PolygonPoint first = figure(InsideFigure.class).points().get(0);
        window.button("next").click();
        robot.waitForIdle();
        assertNotEquals(first, figure(InsideFigure.class).points().get(0));
    }

    @Test
    void languageKeepsTheSceneAndTheMode() {
        choose(PolygonMode.SEED);
        PolygonChoice before = choice();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals("polygon", WindowContent.of(frame).shown());
        assertEquals(before, choice());
    }
}
