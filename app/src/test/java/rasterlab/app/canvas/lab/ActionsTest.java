package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
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
    @DisplayName("what came of a button moves the buttons below the pointer")
    void sentenceLeavesTheButtonsInTheirPlace() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var actions = new Actions(Texts.of("canvas", Language.ENGLISH));
                    actions.add("undo", () -> {});
                    actions.add("redo", () -> {});
                    actions.add("reset", () -> {});
                    var column = new JPanel(new BorderLayout());
                    column.add(actions, BorderLayout.SOUTH);
                    column.setSize(320, 400);
                    List<Rectangle> before = buttons(column, actions);
                    actions.tell(FAR);
                    assertEquals(before, buttons(column, actions));
                    assertTrue(named(actions, "status").isVisible());
                });
    }

    /** Where the buttons stand in the column that is laid out. */
    private static List<Rectangle> buttons(JPanel column, Actions actions) {
        column.doLayout();
        actions.doLayout();
        return Stream.of(actions.getComponents())
                .filter(JButton.class::isInstance)
                .map(each -> SwingUtilities.convertRectangle(actions, each.getBounds(), column))
                .toList();
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
