package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabTheme;

/** The lighting lab's window under a real display, by mouse and keyboard. */
class WindowLightTest extends WindowHarness {
    private static final List<String> LISTS =
            List.of("body", "normals", "kind", "lampColour", "substance", "reflection");

    @BeforeEach
    void showLighting() {
        if (window == null) return;
        show("light");
        await("lit pictures", () -> colors("stage").size() > 50);
    }

    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
    }

    private int number(String slider) {
        return GuiActionRunner.execute(() -> window.slider(slider).target().getValue());
    }

    private String text(String label) {
        return GuiActionRunner.execute(() -> window.label(label).target().getText());
    }

    private void drag(String name, Point from, int right, int down) {
        Component stage = named(name);
        robot.pressMouse(stage, from, MouseButton.LEFT_BUTTON);
        robot.moveMouse(stage, from.x + right / 2, from.y + down / 2);
        robot.moveMouse(stage, from.x + right, from.y + down);
        robot.releaseMouseButtons();
        robot.waitForIdle();
    }

    /** A share of the first picture, which is as wide as a third of the stage. */
    private Point onFirstPicture(double x, double y) {
        Dimension stage = named("stage").getSize();
        return new Point((int) (x * (stage.width - 12) / 3), (int) (y * 0.58 * stage.height));
    }

    @Test
    void draggedRingShowsTheFormulaElsewhere() {
        String before = text("place.value");
        drag("stage", onFirstPicture(0.4, 0.42), 30, 40);
        await("another place", () -> !text("place.value").equals(before));
        window.button("undo").click();
        await("the first place", () -> text("place.value").equals(before));
    }

    @Test
    void lampMovesByItsSliderAndByShiftAndArrows() {
        Set<Integer> before = colors("stage");
        int x = number("x");
        GuiActionRunner.execute(() -> window.slider("x").target().setValue(20));
        await("other light", () -> !colors("stage").equals(before));
        window.button("undo").click();
        await("what was before is back", () -> number("x") == x);
        focus("stage");
        int z = number("z");
        robot.pressKey(KeyEvent.VK_SHIFT);
        for (int i = 0; i < 4; i++) press(KeyEvent.VK_UP);
        robot.releaseKey(KeyEvent.VK_SHIFT);
        await("the lamp is higher", () -> number("z") > z);
    }

    @Test
    void draggedGroundAndArrowsTurnTheBody() {
        String before = text("place.value");
        drag("stage", onFirstPicture(0.5, 0.9), 70, 20);
        await("another point under the ring", () -> !text("place.value").equals(before));
        focus("stage");
        String turned = text("place.value");
        press(KeyEvent.VK_LEFT);
        await("turned by a key", () -> !text("place.value").equals(turned));
    }

    @Test
    void lampsAreAddedChosenAndTakenAway() {
        window.button("grow").click();
        assertEquals(3, lamps());
        GuiActionRunner.execute(() -> window.comboBox("lamp").target().setSelectedIndex(0));
        window.button("shrink").click();
        assertEquals(2, lamps());
    }

    private int lamps() {
        robot.waitForIdle();
        return GuiActionRunner.execute(() -> window.comboBox("lamp").target().getItemCount());
    }

    @Test
    void everyEntryOfEveryListAndEveryBoxCanBeChosen() {
        for (String list : LISTS) {
            var box = window.comboBox(list).target();
            for (int i = box.getItemCount() - 1; i >= 0; i--) {
                int entry = i;
                GuiActionRunner.execute(() -> box.setSelectedIndex(entry));
            }
        }
        for (String box :
                List.of("arrows", "mach", "lamp.on", "term.specular", "localViewer", "twoSided"))
            GuiActionRunner.execute(() -> window.checkBox(box).target().doClick());
        robot.waitForIdle();
        assertFalse(window.checkBox("lamp.on").target().isSelected());
    }

    @Test
    void commandOfASceneInNoFileIsCopiedOnceTheSceneIsSaved() throws Exception {
        Path file = folder.resolve("mine.scene.json");
        var button = window.button("copyCommand").target();
        GuiActionRunner.execute(() -> EventQueue.invokeLater(button::doClick));
        JFileChooserFixture dialog = window.fileChooser("save.dialog");
        String title = GuiActionRunner.execute(() -> dialog.target().getDialogTitle());
        assertTrue(title.contains("command"), title);
        dialog.fileNameTextBox().setText(file.toString());
        dialog.fileNameTextBox().pressAndReleaseKeys(KeyEvent.VK_ENTER);
        await("the command is copied", () -> copied().contains("./lab render " + file));
        assertTrue(Files.readString(file).contains("\"light\""));
        long commands = copied().lines().count();
        assertTrue(commands > 1, copied());
        await(
                "their number is told",
                () -> status().startsWith("On the clipboard: the " + commands + " commands that"));
    }

    /** The text on the clipboard; "" where there is none. */
    private static String copied() {
        var clipboard = Toolkit.getDefaultToolkit().getSystemClipboard();
        try {
            return (String) clipboard.getData(DataFlavor.stringFlavor);
        } catch (UnsupportedFlavorException | IOException e) {
            return "";
        }
    }

    @Test
    void lampGoesOnInAnotherThemeAndAnotherLanguage() {
        GuiActionRunner.execute(() -> window.slider("player.speed").target().setValue(6));
        window.button("player.play").click();
        awaitTheLampMoving();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(LabTheme.DARK)));
        awaitTheLampMoving();
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        awaitTheLampMoving();
        assertEquals(6, number("player.speed"));
        window.button("player.play").click();
    }

    @Test
    void lampOfATabThatIsNotSeenGoesOnWhenItIsSeenAgain() {
        GuiActionRunner.execute(() -> window.slider("player.speed").target().setValue(6));
        window.button("player.play").click();
        show("line");
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(LabTheme.DARK)));
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        show("light");
        awaitTheLampMoving();
        assertEquals(6, number("player.speed"));
        window.button("player.play").click();
    }

    private void awaitTheLampMoving() {
        robot.waitForIdle();
        String before = text("player.count");
        await("the lamp moves", () -> !text("player.count").equals(before));
    }

    @Test
    void chipShowsItsBody() {
        window.button("chip.rounded-cube").click();
        robot.waitForIdle();
        assertEquals("cube", window.comboBox("body").target().getSelectedItem());
    }

    @Test
    void colorModelsFollowEachOtherAndTheCubeTurns() {
        window.comboBox("mode").selectItem(1);
        await("the cube", () -> colors("cube").size() > 500);
        int cyan = number("cmy.cyan");
        GuiActionRunner.execute(() -> window.slider("rgb.red").target().setValue(0));
        robot.waitForIdle();
        assertNotEquals(cyan, number("cmy.cyan"));
        assertEquals(255, number("cmy.cyan"));
        String before = text("player.count");
        drag("cube", new Point(200, 200), 90, 0);
        assertNotEquals(before, text("player.count"));
        window.comboBox("mode").selectItem(0);
        await("light again", () -> named("stage").isShowing());
    }

    @Test
    void languageKeepsTheModeAndTheColor() {
        window.comboBox("mode").selectItem(1);
        GuiActionRunner.execute(() -> window.slider("rgb.red").target().setValue(0));
        String before = text("hex.value");
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals(before, text("hex.value"));
    }
}
