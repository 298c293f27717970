package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.JFormattedTextField;
import javax.swing.JToolTip;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.line.Segment;

/** A number that is refused, by keys, under a real display. */
class WindowNumberTest extends WindowHarness {
    private static final String FIELD = "end.A.x.text";

    @Test
    @DisplayName("who has no mouse is not told why a number is refused")
    void reasonIsSeenWhileTheFieldHasTheKeyboard() {
        Segment before = segment();
        type("3.7");
        String whole = "Allowed: whole numbers from −2147483648 to 2147483647";
        await("the reason", () -> reason().equals(Optional.of(whole)));
        press(KeyEvent.VK_ENTER);
        assertEquals(before, segment());
        assertEquals(Optional.of(whole), reason());
        type("1,234");
        String twofold = "1,234 may be 1.234 or 1234: write the one that is meant";
        await("the next reason", () -> reason().equals(Optional.of(twofold)));
        type("3");
        await("no reason", () -> reason().isEmpty());
        type("x");
        await("the reason again", () -> reason().equals(Optional.of(whole)));
        press(KeyEvent.VK_TAB);
        await("the field left", () -> !GuiActionRunner.execute(field()::isFocusOwner));
        assertFalse(reason().isPresent(), "the reason stays beside the number that is back");
        assertEquals(before, segment());
    }

    private JFormattedTextField field() {
        return robot.finder().findByName(frame, FIELD, JFormattedTextField.class);
    }

    /** Types a text in place of what is there. */
    private void type(String text) {
        robot.focusAndWaitForFocusGain(field());
        GuiActionRunner.execute(() -> field().selectAll());
        robot.enterText(text);
        robot.waitForIdle();
    }

    private Optional<String> reason() {
        return robot
                .finder()
                .findAll(part -> "refusal".equals(part.getName()) && part.isShowing())
                .stream()
                .map(part -> GuiActionRunner.execute(((JToolTip) part)::getTipText))
                .findFirst();
    }
}
