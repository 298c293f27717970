package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JTextArea;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class ActionsTest {
    private static final String FAR =
            "Saved: /home/student/a folder of a course/of computer graphics/of this year/lines.svg";

    private static Component named(Actions actions, String name) {
        return Stream.of(actions.getComponents())
                .filter(part -> name.equals(part.getName()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    @DisplayName("what came of a button is cut off, or stays while others are pressed")
    void sentenceIsReadWholeUntilAnotherButtonIsPressed() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var actions = new Actions(Texts.of("canvas", Language.ENGLISH));
                    actions.add("reset", () -> {});
                    int buttons = actions.getPreferredSize().height;
                    actions.setSize(320, buttons);
                    actions.doLayout();
                    var status = (JTextArea) named(actions, "status");
                    assertFalse(status.isVisible());
                    actions.tell(FAR);
                    int whole = actions.getPreferredSize().height;
                    assertTrue(whole >= buttons + 2 * status.getFont().getSize(), "one line");
                    actions.setSize(320, whole);
                    actions.doLayout();
                    assertEquals(FAR, status.getText());
                    assertTrue(
                            status.getPreferredSize().height <= status.getHeight(),
                            status.getPreferredSize() + " in " + status.getSize());
                    ((JButton) named(actions, "reset")).doClick();
                    assertFalse(status.isVisible());
                    assertEquals(buttons, actions.getPreferredSize().height);
                });
    }
}
