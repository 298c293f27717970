package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Clicks so short that the keyboard comes to a button after what it does has disabled it. */
@Timeout(300)
class WindowShortClickTest extends WindowHarness {
    @ParameterizedTest(name = "the keyboard stays at {0}, which its click disabled")
    @CsvSource({"player.toStart, player.play", "player.toEnd, player.position"})
    void keyboardGoesOnFromAnEnd(String end, String next) {
        show("line");
        window.button("player.back").click();
        focus("end.A");
        clickShortly(end);
        await("the keyboard goes on to " + next, () -> next.equals(focused()));
    }

    @Test
    @DisplayName("the keyboard does not follow work to the button that gives it up, and back")
    void keyboardFollowsTheWork() {
        showHazards();
        window.comboBox("pace").selectItem(1);
        focus("hazards");
        clickShortly("measure");
        await("it can be given up", () -> "cancel".equals(focused()));
        clickShortly("cancel");
        await("it can be begun again", () -> "measure".equals(focused()));
    }

    @ParameterizedTest(name = "the last undo, by {0}, hands the keyboard to redo")
    @ValueSource(strings = {"a short click", "the space bar"})
    void keyboardGoesFromTheLastUndoToThePicture(String way) {
        show("line");
        focus("end.A");
        press(KeyEvent.VK_RIGHT);
        if (way.equals("the space bar")) {
            reachByTab("undo");
            press(KeyEvent.VK_SPACE);
        } else {
            clickShortly("undo");
        }
        await("the keyboard is in the picture", () -> "end.A".equals(focused()));
        assertFalse(window.button("undo").isEnabled());
    }

    /** A control that was reached otherwise leaves the space bar to the player. */
    private void reachByTab(String name) {
        Component button = window.button(name).target();
        GuiActionRunner.execute(
                () -> {
                    button.requestFocusInWindow(FocusEvent.Cause.TRAVERSAL_FORWARD);
                });
        await("the keyboard is at " + name, () -> name.equals(focused()));
    }

    private void clickShortly(String name) {
        Component button = window.button(name).target();
        EventQueue events = Toolkit.getDefaultToolkit().getSystemEventQueue();
        GuiActionRunner.execute(
                () -> {
                    events.postEvent(
                            mouse(button, MouseEvent.MOUSE_PRESSED, InputEvent.BUTTON1_DOWN_MASK));
                    events.postEvent(mouse(button, MouseEvent.MOUSE_RELEASED, 0));
                });
    }

    private static MouseEvent mouse(Component button, int id, int held) {
        return new MouseEvent(
                button,
                id,
                System.currentTimeMillis(),
                held,
                button.getWidth() / 2,
                button.getHeight() / 2,
                1,
                false,
                MouseEvent.BUTTON1);
    }

    private static String focused() {
        return GuiActionRunner.execute(
                () -> {
                    Component owner =
                            KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
                    return owner == null ? "" : String.valueOf(owner.getName());
                });
    }
}
