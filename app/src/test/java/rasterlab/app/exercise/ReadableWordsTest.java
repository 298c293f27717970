package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.Optional;
import javax.swing.JLabel;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.Style;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.panel.CaseTable;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.exercise.panel.SourceEditor;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.score.GradingVerdict;

/** Words stand out from what is behind them as much as WCAG 2.1 asks for, 1.4.3. */
class ReadableWordsTest {
    private static final double LEAST = 4.5;

    private final Texts texts = Texts.of("exercise", Language.ENGLISH);

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @ParameterizedTest(name = "{0}: a verdict drowns")
    @EnumSource(LabTheme.class)
    void verdictsCanBeRead(LabTheme theme) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    theme.install();
                    requireReadable(GradingVerdict.OK);
                    requireReadable(GradingVerdict.WRONG);
                });
    }

    private void requireReadable(GradingVerdict verdict) {
        ResultPane pane = ShownResult.pane(Language.ENGLISH, failure -> {});
        Outcome outcome = ShownResult.outcome(verdict);
        ShownResult.show(pane, BackgroundWork.NONE, Optional.of(outcome));
        Container head = ShownResult.named(pane, "result.verdict").getParent();
        for (Component said : head.getComponents())
            if (said instanceof JLabel) requireReadable(said);
        var table = new CaseTable(texts, () -> {});
        table.show(outcome.cases(), name -> name);
        requireReadable(table.prepareRenderer(table.getCellRenderer(0, 3), 0, 3));
    }

    private static void requireReadable(Component words) {
        requireReadable(words.getName(), words.getForeground(), words.getBackground());
    }

    @ParameterizedTest(name = "{0}: a word of the program drowns")
    @EnumSource(LabTheme.class)
    void programCanBeRead(LabTheme theme) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    theme.install();
                    var editor = new SourceEditor(text -> {});
                    editor.wear(texts);
                    var area = (RSyntaxTextArea) ShownResult.named(editor, "source");
                    for (Style style : area.getSyntaxScheme().getStyles())
                        if (style != null && style.foreground != null)
                            requireReadable(
                                    style.toString(), style.foreground, ground(area, style));
                    editor.close();
                });
    }

    private static Color ground(RSyntaxTextArea area, Style style) {
        return style.background == null ? area.getBackground() : style.background;
    }

    private static void requireReadable(String what, Color words, Color ground) {
        double contrast = MethodColors.contrast(words, ground);
        assertTrue(contrast >= LEAST, () -> what + ": " + contrast);
    }
}
