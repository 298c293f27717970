package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.exercise.BackgroundWork;
import rasterlab.app.exercise.ExerciseState;
import rasterlab.app.exercise.JoinAnswer;
import rasterlab.app.exercise.ShownResult;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.ScorePoints;

/** Messages about lines of a source that was not accepted. */
class RemarkListTest {
    private static final Outcome.Remark LONG =
            new Outcome.Remark(
                    5,
                    0,
                    LocalizedText.of(
                            language -> "the class java.lang.Thread is not allowed ".repeat(8)));

    @Test
    @DisplayName("a long message is cut off, or scrolled to from left to right")
    void longMessagesAreWrapped() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var list = new RemarkList(Texts.of("exercise", Language.ENGLISH), one -> {});
                    var scroll = new JScrollPane(list);
                    list.show(List.of(LONG, LONG));
                    int wide = heightOfRow(list, scroll, 1200);
                    int narrow = heightOfRow(list, scroll, 300);
                    assertTrue(narrow > 2 * wide, narrow + " is not higher than " + wide);
                    assertFalse(scroll.getHorizontalScrollBar().isVisible());
                });
    }

    private static int heightOfRow(RemarkList list, JScrollPane scroll, int width) {
        for (int round = 0; round < 2; round++) {
            scroll.setSize(width, 400);
            scroll.doLayout();
            scroll.getViewport().doLayout();
        }
        assertTrue(list.getWidth() <= width, "the list is " + list.getWidth() + " wide");
        return list.getCellBounds(1, 1).height;
    }

    @Test
    @DisplayName("a click below the last message chooses it")
    void nothingIsBelowTheLastMessage() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var list = new RemarkList(Texts.of("exercise", Language.ENGLISH), one -> {});
                    list.show(List.of(LONG));
                    list.setSize(400, 600);
                    Rectangle row = list.getCellBounds(0, 0);
                    assertEquals(0, list.locationToIndex(new Point(9, row.height / 2)));
                    assertEquals(-1, list.locationToIndex(new Point(9, row.height + 9)));
                });
    }

    @Test
    @DisplayName("of two messages about one line only the first is read beside it")
    void messagesOfOnePlaceAreReadTogether() {
        var one = new Outcome.Remark(5, 0, new LocalizedText("exit", "выход"));
        var other = new Outcome.Remark(5, 0, new LocalizedText("random", "случай"));
        var elsewhere = new Outcome.Remark(5, 9, new LocalizedText("type", "тип"));
        assertEquals(
                List.of(
                        new Outcome.Remark(
                                5, 0, new LocalizedText("exit\nrandom", "выход\nслучай")),
                        elsewhere),
                RemarkNotices.byPlace(List.of(one, elsewhere, other)));
    }

    @Test
    @DisplayName("messages of the text before stand below the run of another")
    void messagesGoWithTheirText() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var checking =
                            new BackgroundWork(BackgroundWork.Phase.CHECKING, 0, 9, List.of());
                    assertTrue(tellsRemarks("class A {", "class A {", BackgroundWork.NONE));
                    assertTrue(tellsRemarks("class A {", "class A {", checking));
                    assertFalse(tellsRemarks("class A {", "class A { }", checking));
                });
    }

    private static boolean tellsRemarks(String refused, String source, BackgroundWork work) {
        var pane = ShownResult.pane(Language.ENGLISH, failure -> {});
        var outcome =
                new Outcome(
                        refused,
                        0,
                        GradingVerdict.COMPILE_ERROR.code(),
                        new ScorePoints(0, 0, 0, 100),
                        List.of(),
                        List.of(LONG),
                        LocalizedText.NOTHING,
                        0,
                        false);
        pane.show(
                new ExerciseState(
                        ShownResult.EXERCISE,
                        source,
                        List.of(),
                        Optional.of(outcome),
                        work,
                        Notice.NONE,
                        Notice.NONE,
                        Optional.empty(),
                        JoinAnswer.NONE),
                CaseResult.untried(ShownResult.EXERCISE));
        Component remarks = named(pane, "remarks.scroll");
        Component cases = named(pane, "cases.scroll").getParent();
        assertEquals(remarks.isVisible(), !cases.isVisible());
        return remarks.isVisible();
    }
}
