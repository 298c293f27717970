package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.exercise.BackgroundWork;
import rasterlab.app.exercise.ShownResult;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.VerdictLook;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.GradingVerdict;

@Tag("slow")
class CaseTableTest {
    private final Texts texts = Texts.of("exercise", Language.RUSSIAN);

    private static CaseResult one(String verdict) {
        return new CaseResult(
                "last-pixel-is-dropped", verdict, 0, 4, LocalizedText.NOTHING, List.of(), "");
    }

    @Test
    @DisplayName("a verdict longer than those before it is cut off")
    void columnsGrowWithTheirWords() throws Exception {
        var cut = new ArrayList<String>();
        EventQueue.invokeAndWait(
                () -> {
                    var table = new CaseTable(texts, () -> {});
                    table.setSize(640, 200);
                    table.doLayout();
                    for (GradingVerdict verdict : GradingVerdict.values()) {
                        table.show(List.of(one(verdict.code())), name -> name);
                        table.doLayout();
                        assertEquals(4, table.getColumnCount(), verdict.code());
                        for (int column = 0; column < 4; column++)
                            if (table.getCellRect(0, column, false).width < needed(table, column))
                                cut.add(verdict.code() + ": column " + column);
                    }
                });
        assertEquals(List.of(), cut);
    }

    @Test
    @DisplayName("a case is called in English in the Russian window, or its name is nowhere")
    void casesHaveTitlesAndTipsTheirNames() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    Exercise exercise = Catalogue.builtIn().all().get(0);
                    var table = new CaseTable(texts, () -> {});
                    table.show(List.of(one("")), name -> exercise.caseTitle(name, "ru"));
                    assertEquals("последний пиксель нарисован", table.getValueAt(0, 1));
                    var cell = table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
                    assertEquals(
                            "последний пиксель нарисован (last-pixel-is-dropped)",
                            ((JComponent) cell).getToolTipText());
                });
    }

    @ParameterizedTest(name = "the table and the head call a verdict differently: {0}")
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "NOT_RUN")
    void verdictsAreSaidInTheSameWords(GradingVerdict verdict) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    ResultPane pane = ShownResult.pane(Language.RUSSIAN, failure -> {});
                    Outcome outcome = ShownResult.outcome(verdict);
                    ShownResult.show(pane, BackgroundWork.NONE, Optional.of(outcome));
                    var head = (JLabel) ShownResult.named(pane, "result.verdict");
                    var table = new CaseTable(texts, () -> {});
                    table.setSize(280, 200);
                    table.show(outcome.cases(), name -> name);
                    table.doLayout();
                    Object said = table.getModel().getValueAt(0, 3);
                    assertEquals(head.getText(), VerdictLook.sign(verdict.code()) + " " + said);
                });
    }

    @Test
    @DisplayName("a speed that is worth no points has a tick")
    void worthlessSpeedHasNoTick() {
        assertEquals("✗", VerdictLook.sign(GradingVerdict.TOO_SLOW.code()));
    }

    private static int needed(CaseTable table, int column) {
        var cell = table.prepareRenderer(table.getCellRenderer(0, column), 0, column);
        int wide = cell.getPreferredSize().width;
        assertTrue(wide > 0, "column " + column);
        return wide;
    }
}
