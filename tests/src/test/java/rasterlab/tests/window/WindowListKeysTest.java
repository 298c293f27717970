package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.Optional;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;

/** Lists that lead to a tab's other labs, by keys, under a real display. */
class WindowListKeysTest extends WindowHarness {
    @ParameterizedTest(name = "a key of the list moves the picture: {0}")
    @ValueSource(
            strings = {
                "line",
                "polygon",
                "clip",
                "coordinates",
                "spline",
                "visibility",
                "light",
                "opengl"
            })
    void listKeepsTheKeyboardUnderItsKeys(String tab) {
        show(tab);
        String list = tab.equals("opengl") ? "group" : "mode";
        window.comboBox(list).focus();
        int first = chosen(list).orElseThrow();
        int last = count(list) - 1;
        for (int i = first + 1; i <= last; i++) pressAndExpect(list, KeyEvent.VK_DOWN, i);
        for (int i = last - 1; i >= 0; i--) pressAndExpect(list, KeyEvent.VK_UP, i);
    }

    private void pressAndExpect(String list, int key, int expected) {
        press(key);
        assertEquals(Optional.of(expected), chosen(list), "the list with the keyboard");
    }

    @Test
    @DisplayName("a click in the list does not lead to the picture")
    void pictureHasTheKeyboardAfterAClick() {
        show("spline");
        window.comboBox("mode").selectItem(SplineMode.FUNCTION.ordinal());
        robot.waitForIdle();
        var before = models.of(new SplineRoom()).function().state().choice().knots();
        press(KeyEvent.VK_UP);
        var after = models.of(new SplineRoom()).function().state().choice().knots();
        assertEquals(before.get(0).x(), after.get(0).x());
        assertTrue(after.get(0).y() > before.get(0).y(), after.toString());
    }

    /** The place of what is chosen in the list, empty where the keyboard is elsewhere. */
    private Optional<Integer> chosen(String list) {
        return GuiActionRunner.execute(
                () ->
                        KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()
                                                instanceof NameChooser owner
                                        && owner.getName().equals(list)
                                ? Optional.of(owner.getSelectedIndex())
                                : Optional.empty());
    }

    private int count(String list) {
        return window.comboBox(list).contents().length;
    }
}
