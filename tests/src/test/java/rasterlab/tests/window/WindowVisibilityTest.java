package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTable;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.visibility.VisibilityLabState;
import rasterlab.app.visibility.VisibilityRoom;

/** The hidden-surface lab's window under a real display, by mouse and keyboard. */
class WindowVisibilityTest extends WindowHarness {
    /** Each list of choices of the inspector that is always there. */
    private static final List<String> LISTS =
            List.of(
                    "scene",
                    "method",
                    "comparison",
                    "shading",
                    "projection",
                    "view",
                    "timeline",
                    "cull",
                    "sides",
                    "stereo");

    @BeforeEach
    void showHiddenSurfaces() {
        if (window == null) return;
        show("visibility");
        await("a first picture", () -> state().picture().isPresent());
    }

    private VisibilityLabState state() {
        return GuiActionRunner.execute(() -> models.of(new VisibilityRoom()).state());
    }

    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
    }

    private void click(String name, Point place) {
        robot.moveMouse(named(name), place);
        robot.pressMouse(named(name), place, MouseButton.LEFT_BUTTON);
        robot.releaseMouseButtons();
        robot.waitForIdle();
    }

    private Point middle(String name) {
        Dimension size = named(name).getSize();
        return new Point(size.width / 2, size.height / 2);
    }

    @Test
    void dragTurnsTheSceneAsOneChange() {
        var before = state().choice();
        Component stage = named("stage");
        Point middle = middle("stage");
        robot.pressMouse(stage, middle, MouseButton.LEFT_BUTTON);
        robot.moveMouse(stage, middle.x + 40, middle.y + 10);
        robot.moveMouse(stage, middle.x + 80, middle.y + 20);
        robot.releaseMouseButtons();
        robot.waitForIdle();
        assertNotEquals(before.camera(), state().choice().camera());
        window.button("undo").click();
        await("what was before is back", () -> state().choice().equals(before));
    }

    @Test
    void clickShowsThePixelsHistoryAndShiftWithArrowsMovesIt() {
        double theta = theta();
        click("stage", middle("stage"));
        await("faces that touched the pixel", () -> rows() >= 2);
        assertEquals(theta, theta(), "a click turned the scene");
        String before = pixel();
        focus("stage");
        robot.pressKey(KeyEvent.VK_SHIFT);
        press(KeyEvent.VK_RIGHT);
        robot.releaseKey(KeyEvent.VK_SHIFT);
        robot.waitForIdle();
        assertNotEquals(before, pixel());
        assertEquals(theta, theta(), "moving the pixel turned the scene");
    }

    private String pixel() {
        return GuiActionRunner.execute(() -> ((JLabel) named("pixel.value")).getText());
    }

    private int rows() {
        return GuiActionRunner.execute(() -> ((JTable) named("history")).getRowCount());
    }

    @Test
    void timelineStepsThroughTheOrderAndTheListFollows() {
        window.comboBox("timeline").selectItem(1);
        await("300 faces in order", () -> steps().getModel().getSize() == 300);
        window.button("player.toStart").click();
        robot.waitForIdle();
        window.button("player.forward").click();
        window.button("player.forward").click();
        await("the list stands at the second step", () -> selected() == 1);
        GuiActionRunner.execute(() -> steps().setSelectedIndex(9));
        await(
                "the timeline stands at the tenth",
                () -> window.slider("player.position").target().getValue() == 10);
    }

    private JList<?> steps() {
        return (JList<?>) named("steps");
    }

    private int selected() {
        return GuiActionRunner.execute(() -> steps().getSelectedIndex());
    }

    @Test
    void chipShowsWhatFailsBesideWhatDoesNot() {
        window.button("chip.cyclic").click();
        window.comboBox("comparison").selectItem("newell");
        await("both are compared", () -> state().otherDifference().isPresent());
        assertTrue(state().difference().orElseThrow().wrongPixels() > 1000);
        assertEquals(0, state().otherDifference().orElseThrow().wrongPixels());
    }

    @Test
    void chartIsCountedInTheBackgroundAndCanBeGivenUp() {
        window.comboBox("view").selectItem(2);
        window.button("counting.cancel").click();
        robot.waitForIdle();
        assertEquals(
                0,
                GuiActionRunner.execute(() -> window.comboBox("view").target().getSelectedIndex()));
        window.comboBox("view").selectItem(3);
        await("the chart is there", () -> colors("stage").size() > 20);
    }

    /** Keeping is what Enter answers, and leads back to the dialog. */
    @Test
    void savedSceneReplacesAFileOnlyIfThatIsSaid() throws Exception {
        Path file = folder.resolve("mine.scene.json");
        Files.writeString(file, "mine");
        saveTo(folder.resolve("mine"));
        window.optionPane().pressAndReleaseKeys(KeyEvent.VK_ENTER);
        JFileChooserFixture dialog = window.fileChooser("save.dialog");
        assertEquals("mine", Files.readString(file));
        GuiActionRunner.execute(() -> dialog.target().cancelSelection());
        saveTo(file);
        window.optionPane().buttonWithText("Replace").pressAndReleaseKeys(KeyEvent.VK_SPACE);
        await("the scene is in the file", () -> text(file).contains("\"vase\""));
        await("where it is", () -> status().endsWith(file.toString()));
    }

    /** Saves by the keyboard, for dialogs are not where a mouse would look for them. */
    private void saveTo(Path file) {
        GuiActionRunner.execute(
                () -> EventQueue.invokeLater(() -> ((AbstractButton) named("save")).doClick()));
        JFileChooserFixture dialog = window.fileChooser("save.dialog");
        dialog.fileNameTextBox().setText(file.toString());
        dialog.fileNameTextBox().pressAndReleaseKeys(KeyEvent.VK_ENTER);
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void everyEntryOfEveryListCanBeChosen() {
        for (String list : LISTS) {
            int entries = window.comboBox(list).target().getItemCount();
            for (int i = entries - 1; i >= 0; i--) {
                int entry = i;
                GuiActionRunner.execute(
                        () -> window.comboBox(list).target().setSelectedIndex(entry));
            }
            robot.waitForIdle();
        }
        await("the last picture", () -> state().picture().isPresent());
    }

    @Test
    void languageKeepsSceneAndPixel() {
        click("stage", middle("stage"));
        var before = state().choice();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals(before, state().choice());
        await("the history is shown again", () -> rows() >= 2);
    }
}
