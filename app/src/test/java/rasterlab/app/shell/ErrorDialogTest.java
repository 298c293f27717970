package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;

class ErrorDialogTest {
    @BeforeAll
    static void theme() {
        LabTheme.LIGHT.install();
    }

    @ParameterizedTest(name = "dialog is as wide as its sentence: {0}")
    @ValueSource(strings = {"a word and another ", "/a/folder/in/another"})
    void longSentenceIsWrapped(String part) {
        String message = part.repeat(25).strip();
        JPanel content =
                new ErrorDialog(Texts.of("shell", Language.ENGLISH))
                        .content(new IllegalStateException(message));
        JPanel brief =
                new ErrorDialog(Texts.of("shell", Language.ENGLISH))
                        .content(new IllegalStateException("brief"));
        Dimension size = content.getPreferredSize();
        assertEquals(brief.getPreferredSize().width, size.width);
        content.setSize(size);
        content.doLayout();
        var sentence = (JTextArea) named(content, "error.sentence");
        assertTrue(sentence.getText().endsWith(message), sentence.getText());
        int lines = sentence.getHeight() / sentence.getFontMetrics(sentence.getFont()).getHeight();
        assertTrue(lines > 2, lines + " lines");
        assertTrue(
                sentence.getPreferredSize().height <= sentence.getHeight(),
                "the last lines are cut off");
    }

    private static Component named(JPanel panel, String name) {
        return Stream.of(panel.getComponents())
                .filter(part -> name.equals(part.getName()))
                .findFirst()
                .orElseThrow();
    }
}
