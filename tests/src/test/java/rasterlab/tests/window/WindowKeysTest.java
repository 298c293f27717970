package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.FocusTraversalPolicy;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JTable;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabTabs;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.line.Segment;
import rasterlab.tests.bench.window.WindowContent;

/** Where the keyboard goes: to the picture of the chosen tab. */
class WindowKeysTest extends WindowHarness {
    /** Colour around what has the keyboard, in the light theme. */
    private static final int FOCUS = StageColors.LIGHT.focus().getRGB();

    private static final List<String> TABS = LabTabs.NAMES;

    /** Radians that an arrow key turns the vase about its axis, as in the coursework. */
    private static final double STEP = 0.03 * Math.PI;

    @Test
    void arrowKeysTurnTheVaseAsInTheCoursework() {
        show("visibility");
        double theta = theta();
        await("the vase is drawn", () -> colors("stage").size() > 40);
        focus("stage");
        press(KeyEvent.VK_RIGHT);
        press(KeyEvent.VK_RIGHT);
        await("two steps", () -> Math.abs(theta() - theta - 0.06 * Math.PI) < 1e-9);
        await(
                "the new view is drawn",
                () ->
                        models.of(new VisibilityRoom())
                                .state()
                                .picture()
                                .orElseThrow()
                                .request()
                                .camera()
                                .equals(models.of(new VisibilityRoom()).state().choice().camera()));
    }

    @Test
    void tabChoosesTheEndThatTheArrowsMove() {
        Segment before = segment();
        focus("end.A");
        press(KeyEvent.VK_RIGHT);
        press(KeyEvent.VK_TAB);
        robot.pressKey(KeyEvent.VK_SHIFT);
        press(KeyEvent.VK_DOWN);
        robot.releaseKey(KeyEvent.VK_SHIFT);
        robot.waitForIdle();
        var moved = new Segment(before.x0() + 1, before.y0(), before.x1(), before.y1() + 10);
        assertEquals(moved, segment());
    }

    @Test
    @DisplayName("the control that has the keyboard is scrolled out of sight")
    void controlWithTheKeyboardIsSeen() {
        show("light");
        JComponent first = window.comboBox("body").target();
        JComponent last = window.checkBox("twoSided").target();
        for (JComponent control : List.of(first, last, first)) {
            robot.focusAndWaitForFocusGain(control);
            assertTrue(isWhole(control), control.getName());
        }
    }

    private static boolean isWhole(JComponent control) {
        return GuiActionRunner.execute(
                () -> control.getVisibleRect().height == control.getHeight());
    }

    @Test
    @DisplayName("who moves by Tab does not come out of the table of hazards")
    void tabLeavesTheHazards() {
        showHazards();
        JTable table = window.table("hazards").target();
        robot.focusAndWaitForFocusGain(table);
        press(KeyEvent.VK_TAB);
        assertFalse(table.isFocusOwner());
    }

    @ParameterizedTest(name = "keys go elsewhere after the tab is chosen by {0}")
    @ValueSource(strings = {"mouse", "mnemonic", "arrow"})
    void chosenTabsPictureTakesTheKeys(String way) {
        window.comboBox("language").focus();
        choose("visibility", way);
        awaitKeyboard("stage");
        double theta = theta();
        press(KeyEvent.VK_RIGHT);
        press(KeyEvent.VK_DOWN);
        await("one step", () -> Math.abs(theta() - theta - STEP) < 1e-9);
        assertEquals(Language.ENGLISH, frame.language());
        assertTrue(colors("stage").contains(FOCUS), "focus is not seen");
        choose("line", way);
        awaitKeyboard("end.A");
        Segment before = segment();
        press(KeyEvent.VK_RIGHT);
        await("the end has moved", () -> segment().x0() == before.x0() + 1);
        assertEquals(theta + STEP, theta(), 1e-9);
        assertTrue(colors("end.A").contains(FOCUS), "focus is not seen");
    }

    private void choose(String tab, String way) {
        switch (way) {
            case "mouse" -> window.tabbedPane("tabs").selectTab(TABS.indexOf(tab));
            case "mnemonic" -> {
                robot.pressKey(KeyEvent.VK_ALT);
                press(KeyEvent.VK_1 + TABS.indexOf(tab));
                robot.releaseKey(KeyEvent.VK_ALT);
            }
            default -> {
                int key = tab.equals("line") ? KeyEvent.VK_LEFT : KeyEvent.VK_RIGHT;
                while (!WindowContent.of(frame).shown().equals(tab)) {
                    focus("tabs");
                    press(key);
                }
            }
        }
        robot.waitForIdle();
        assertEquals(tab, WindowContent.of(frame).shown());
    }

    private static void awaitKeyboard(String name) {
        await(name + " has the keyboard", () -> name.equals(keyboardName()));
    }

    private static String keyboardName() {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return owner == null ? null : owner.getName();
    }

    @Test
    void clickOnTheShownTabGivesTheKeysToItsPictureToo() {
        Segment before = segment();
        window.comboBox("language").focus();
        choose("line", "mouse");
        awaitKeyboard("end.A");
        press(KeyEvent.VK_RIGHT);
        assertEquals(before.x0() + 1, segment().x0());
        assertEquals(Language.ENGLISH, frame.language());
    }

    @Test
    void openedWindowsPictureTakesTheKeys() {
        Segment before = segment();
        press(KeyEvent.VK_DOWN);
        assertEquals(before.y0() + 1, segment().y0());
    }

    @ParameterizedTest(name = "picture of {0} does not take the keys by a click")
    @ValueSource(strings = {"line", "visibility"})
    void clickOnThePictureTakesTheKeys(String tab) {
        show(tab);
        window.comboBox("language").focus();
        Segment before = segment();
        double theta = theta();
        Component stage = window.robot().finder().findByName(frame, "stage");
        robot.click(stage, new Point(stage.getWidth() - 40, 60));
        press(KeyEvent.VK_RIGHT);
        boolean line = tab.equals("line");
        assertEquals(before.x0() + (line ? 1 : 0), segment().x0());
        assertEquals(theta + (line ? 0 : STEP), theta(), 1e-9);
        assertEquals(Language.ENGLISH, frame.language());
    }

    @Test
    void clickBesideTheSegmentKeepsTheEndThatTheKeysMove() {
        Segment before = segment();
        focus("end.B");
        window.comboBox("language").focus();
        Component stage = window.robot().finder().findByName(frame, "stage");
        robot.click(stage, new Point(stage.getWidth() - 40, 60));
        press(KeyEvent.VK_UP);
        var moved = new Segment(before.x0(), before.y0(), before.x1(), before.y1() - 1);
        assertEquals(moved, segment());
    }

    @Test
    void otherLanguageLeavesTheKeysToTheShownPicture() {
        show("visibility");
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        double theta = theta();
        press(KeyEvent.VK_RIGHT);
        assertEquals(theta + STEP, theta(), 1e-9);
    }

    @Test
    void otherLanguageGivesThePictureTheKeysWhenNothingHasThem() {
        show("visibility");
        GuiActionRunner.execute(
                () -> KeyboardFocusManager.getCurrentKeyboardFocusManager().clearFocusOwner());
        robot.waitForIdle();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        double theta = theta();
        press(KeyEvent.VK_RIGHT);
        assertEquals(theta + STEP, theta(), 1e-9);
    }

    @Test
    void keysChooseTheSizeOfType() {
        int usual = typeSize();
        pressWithControl(KeyEvent.VK_EQUALS);
        pressWithControl(KeyEvent.VK_EQUALS);
        assertEquals(125, frame.look().textPercent());
        assertEquals(Math.round(usual * 1.25f), typeSize());
        pressWithControl(KeyEvent.VK_MINUS);
        assertEquals(110, frame.look().textPercent());
        pressWithControl(KeyEvent.VK_0);
        assertEquals(usual, typeSize());
    }

    @Test
    @DisplayName("type grows only by the equals sign's key without shift, which is no plus")
    void plusOnAnAmericanKeyboardMakesTypeLarger() {
        robot.pressKey(KeyEvent.VK_SHIFT);
        pressWithControl(KeyEvent.VK_EQUALS);
        robot.releaseKey(KeyEvent.VK_SHIFT);
        assertEquals(110, frame.look().textPercent());
    }

    @Test
    void keyOpensTheMenuOfLooks() {
        press(KeyEvent.VK_F10);
        press(KeyEvent.VK_DOWN);
        press(KeyEvent.VK_DOWN);
        press(KeyEvent.VK_DOWN);
        int usual = typeSize();
        press(KeyEvent.VK_ENTER);
        await("the projector's look", () -> frame.look().theme() == LabTheme.PROJECTOR);
        assertTrue(typeSize() > usual, "type did not grow");
    }

    private int typeSize() {
        return GuiActionRunner.execute(
                () -> window.comboBox("language").target().getFont().getSize());
    }

    @Test
    void windowsKeysWorkWhateverHasTheKeyboard() {
        showHazards();
        keepsNoKeyOfTheWindow("study", "hazards");
        keepsNoKeyOfTheWindow("exercises", "source");
        keepsNoKeyOfTheWindow("exercises", "statement");
        keepsNoKeyOfTheWindow("exercises", "cases");
        keepsNoKeyOfTheWindow("opengl", "calls");
        keepsNoKeyOfTheWindow("line", "language");
    }

    private void keepsNoKeyOfTheWindow(String tab, String name) {
        show(tab);
        focus(name);
        pressWithControl(KeyEvent.VK_PAGE_DOWN);
        String next = TABS.get((TABS.indexOf(tab) + 1) % TABS.size());
        await(name + ": the next tab", () -> isSeen(next));
        pressWithControl(KeyEvent.VK_PAGE_UP);
        await(name + ": the tab before", () -> isSeen(tab));
        focus(name);
        pressWithControl(KeyEvent.VK_EQUALS);
        await(name + ": larger type", () -> frame.look().textPercent() == 110);
        focus(name);
        pressWithControl(KeyEvent.VK_0);
        await(name + ": usual type", () -> frame.look().textPercent() == 100);
        focus(name);
        press(KeyEvent.VK_F10);
        await(name + ": the menu of looks", () -> isSeen("look.menu"));
        press(KeyEvent.VK_ESCAPE);
        await("no menu of looks", () -> !isSeen("look.menu"));
    }

    @Test
    void tableLeavesTheKeyOfTheControlsToTheWindow() {
        showHazards();
        focus("hazards");
        press(KeyEvent.VK_F9);
        await("no controls", () -> !isSeen("topic"));
        press(KeyEvent.VK_F9);
        await("the controls", () -> isSeen("topic"));
    }

    @Test
    void controlAndTabChooseTheNextTabFromATableAndFromTheEditor() {
        showHazards();
        focus("hazards");
        pressWithControl(KeyEvent.VK_TAB);
        await("the next tab", () -> isSeen("exercises"));
        focus("source");
        pressWithControl(KeyEvent.VK_TAB);
        await("the first tab", () -> isSeen("coordinates"));
    }

    @Test
    void tabIndentsInTheEditor() {
        show("exercises");
        focus("source");
        String before = window.textBox("source").text();
        press(KeyEvent.VK_TAB);
        assertTrue(source().isFocusOwner(), "Tab leaves the editor");
        String after = window.textBox("source").text();
        assertNotEquals(before, after);
        assertEquals(before.replaceAll("\\s", ""), after.replaceAll("\\s", ""));
    }

    @ParameterizedTest(name = "F6 stays in the editor, Shift: {0}")
    @ValueSource(booleans = {false, true})
    void editorIsLeftForWhatFollowsItOrStandsBeforeIt(boolean back) {
        show("exercises");
        // In a wide window the panes beside each other have a F6 of their own.
        window.resizeTo(new Dimension(960, 640));
        await("the editor behind a tab", () -> isSeen("rooms"));
        window.tabbedPane("rooms").selectTab(1);
        focus("source");
        Component wanted = GuiActionRunner.execute(() -> besideTheEditor(back));
        if (back) robot.pressKey(KeyEvent.VK_SHIFT);
        press(KeyEvent.VK_F6);
        if (back) robot.releaseKey(KeyEvent.VK_SHIFT);
        await(wanted.toString(), wanted::isFocusOwner);
        assertEquals("exercises", WindowContent.of(frame).shown());
    }

    private Component source() {
        return window.robot().finder().findByName(frame, "source");
    }

    private Component besideTheEditor(boolean back) {
        FocusTraversalPolicy order = frame.getFocusTraversalPolicy();
        return back
                ? order.getComponentBefore(frame, source())
                : order.getComponentAfter(frame, source());
    }

    private void pressWithControl(int key) {
        robot.pressKey(KeyEvent.VK_CONTROL);
        press(key);
        robot.releaseKey(KeyEvent.VK_CONTROL);
        robot.waitForIdle();
    }
}
