package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.stream.Stream;
import org.assertj.swing.data.TableCell;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.line.LineRoom;
import rasterlab.tests.bench.window.WindowContent;

/** Opens the window for the first time, and presses what a new user sees. */
class WindowFirstSightTest extends WindowHarness {
    @ParameterizedTest(name = "the keys of the player do nothing after a click on {0}")
    @ValueSource(strings = {"chip.steep", "method", "stage", "player.speed"})
    void playerKeysWorkWhereverTheKeyboardIs(String control) {
        if (control.equals("method")) window.comboBox(control).focus();
        else robot.click(robot.finder().findByName(control, true));
        robot.waitForIdle();
        int last = models.of(new LineRoom()).last();
        press(KeyEvent.VK_HOME);
        assertEquals(1, step());
        press(KeyEvent.VK_PAGE_DOWN);
        assertEquals(2, step());
        press(KeyEvent.VK_END);
        assertEquals(last, step());
        press(KeyEvent.VK_SPACE);
        await("it plays", () -> step() < last);
        press(KeyEvent.VK_SPACE);
    }

    private int step() {
        robot.waitForIdle();
        return GuiActionRunner.execute(() -> models.of(new LineRoom()).step());
    }

    @Test
    @DisplayName("the sentence on the stage stays when something was done, or is not there before")
    void sentenceOnTheStageGoesWhenSomethingIsDone() {
        assertTrue(isSeen("stage.hint"));
        press(KeyEvent.VK_PAGE_UP);
        assertFalse(isSeen("stage.hint"));
    }

    @Test
    void methodsThatFailAreButtonsOverTheStage() {
        window.button("chip.steep").click();
        window.label("hazard.verdict").requireText("bresenham: exact");
        window.button("hazard.method.naive-textbook").click();
        assertEquals("naive-textbook", models.of(new LineRoom()).state().choice().method());
        window.label("hazard.verdict").requireText("naive-textbook: wrong");
        window.button("hazard.method.bresenham").click();
        assertEquals("bresenham", models.of(new LineRoom()).state().choice().method());
    }

    @Test
    @DisplayName("a hazard that the table of verdicts opens is shown without its verdicts")
    void openedHazardIsToldInItsTab() {
        showHazards();
        window.table("hazards").selectCell(TableCell.row(0).column(0));
        robot.waitForIdle();
        window.button("open").click();
        await("the strip", () -> isSeen("hazard.strip"));
        assertEquals("line", WindowContent.of(frame).shown());
        window.label("hazard.verdict").requireText("naive-textbook: exact");
    }

    @Test
    void f1ListsWhatCanBeDoneAndGoesByEscape() {
        press(KeyEvent.VK_F1);
        await("the help", () -> help().count() == 1);
        await("its keyboard", () -> help().allMatch(Window::isFocused));
        press(KeyEvent.VK_ESCAPE);
        await("no help", () -> help().count() == 0);
    }

    private static Stream<Window> help() {
        return Stream.of(Window.getWindows())
                .filter(each -> "help".equals(each.getName()) && each.isShowing());
    }
}
