package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.Exercise.TaskKind;

class SourceEditorTest {
    private static final String LONG_LINE = "int x = 1; ".repeat(20) + "\nint y;\n";

    @BeforeAll
    static void lookLikeTheLab() {
        LabTheme.LIGHT.install();
    }

    @Test
    @DisplayName("after smaller type the editor stays as wide as the larger was, and scrolls")
    void longestLineIsMeasuredAnewAfterTheTypeHasChanged() {
        SourceEditor fresh = editor(13);
        SourceEditor changed = editor(27);
        changed.removeNotify();
        changed.wear(Texts.of("exercise", Language.ENGLISH));
        changed.setPoints(13);
        width(changed);
        changed.addNotify();
        assertEquals(width(fresh), width(changed), "between two windows");
        changed.setPoints(20);
        changed.setPoints(13);
        assertEquals(width(fresh), width(changed), "in a window");
        fresh.close();
        changed.close();
    }

    @Test
    @DisplayName(
            "over a selection, a closing brace stands behind the one that the editor has put in")
    void aClosingBraceIsTypedOnce() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var editor = new SourceEditor(text -> {});
                    editor.wear(Texts.of("exercise", Language.ENGLISH));
                    editor.show("line", TaskKind.BREAK, "old");
                    var area = (JTextArea) named(editor, "source").orElseThrow();
                    area.selectAll();
                    type(area, "{\"a\": [1]}");
                    assertEquals("{\"a\": [1]}", area.getText());
                    editor.close();
                });
    }

    private static void type(JTextArea area, String text) {
        for (char each : text.toCharArray())
            SwingUtilities.processKeyBindings(
                    new KeyEvent(area, KeyEvent.KEY_TYPED, 0, 0, KeyEvent.VK_UNDEFINED, each));
    }

    private static SourceEditor editor(int points) {
        var editor = new SourceEditor(text -> {});
        editor.wear(Texts.of("exercise", Language.ENGLISH));
        editor.setPoints(points);
        editor.show("line", TaskKind.WRITE, LONG_LINE);
        editor.addNotify();
        width(editor);
        return editor;
    }

    private static int width(SourceEditor editor) {
        return named(editor, "source").orElseThrow().getPreferredSize().width;
    }

    private static Optional<Component> named(Container container, String name) {
        return Stream.of(container.getComponents())
                .flatMap(
                        each ->
                                name.equals(each.getName())
                                        ? Stream.of(each)
                                        : each instanceof Container inner
                                                ? named(inner, name).stream()
                                                : Stream.empty())
                .findFirst();
    }
}
