package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.EXERCISE;
import static rasterlab.app.exercise.ShownResult.judged;
import static rasterlab.app.exercise.ShownResult.named;
import static rasterlab.app.exercise.ShownResult.outcome;
import static rasterlab.app.exercise.ShownResult.pane;
import static rasterlab.app.exercise.ShownResult.show;

import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JLabel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** The place of the result before there is one. */
class ResultGuideTest {
    private static final List<Throwable> FAILURES = new CopyOnWriteArrayList<>();

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
        assertEquals(List.of(), FAILURES);
    }

    @ParameterizedTest(name = "the bar is full or at its begin while it compiles: {0}, {1} of {2}")
    @CsvSource({
        "CHECKING, 0, 12, true, compiling",
        "CHECKING, 3, 12, false, case 3 of 12",
        "SENDING, 0, 0, true, sending",
        "WAITING, 2, 0, true, place 2 in the queue"
    })
    void barTellsOnlyWhatIsDone(
            BackgroundWork.Phase phase, int done, int of, boolean unknown, String said)
            throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    ResultPane pane = pane(Language.ENGLISH, FAILURES::add);
                    show(pane, new BackgroundWork(phase, done, of, List.of()), Optional.empty());
                    var bar = (JProgressBar) named(pane, "progress");
                    assertEquals(unknown, bar.isIndeterminate());
                    assertEquals(said, bar.getString());
                });
    }

    @ParameterizedTest(name = "half the window is empty: {0}, type of {1} in {2}×{3}")
    @CsvSource({
        "ENGLISH, 14, 780, 340",
        "RUSSIAN, 14, 780, 340",
        "ENGLISH, 14, 870, 430",
        "RUSSIAN, 14, 870, 430",
        "RUSSIAN, 19, 1200, 560"
    })
    void saysWhatToDoUntilThereIsAResult(Language language, double type, int width, int height)
            throws Exception {
        var made = new AtomicReference<ResultPane>();
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.LIGHT, type);
                    made.set(pane(language, FAILURES::add));
                    show(made.get(), BackgroundWork.NONE, Optional.empty());
                });
        OffscreenPainter.paint(made.get(), width, height);
        EventQueue.invokeAndWait(() -> assertWhole(made.get(), language));
        EventQueue.invokeAndWait(
                () -> {
                    show(made.get(), BackgroundWork.NONE, Optional.of(outcome(GradingVerdict.OK)));
                    assertFalse(named(made.get(), "guide.scroll").isVisible(), "still there");
                    assertTrue(named(made.get(), "case.picture").isVisible());
                    made.get().close();
                });
    }

    @ParameterizedTest(name = "speaks of a program where inputs are handed in: {0}, type of {1}")
    @CsvSource({
        "ENGLISH, 14, 780, 340, compiles",
        "RUSSIAN, 14, 780, 340, компилирует",
        "RUSSIAN, 19, 1200, 560, компилирует"
    })
    void saysThatInputsAreHandedInWhereMethodsAreToBeBroken(
            Language language, double type, int width, int height, String compiles)
            throws Exception {
        Exercise breaking = Catalogue.builtIn().named("break-line");
        var made = new AtomicReference<ResultPane>();
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.LIGHT, type);
                    made.set(pane(language, FAILURES::add));
                    show(made.get(), breaking, BackgroundWork.NONE, Optional.empty());
                });
        OffscreenPainter.paint(made.get(), width, height);
        EventQueue.invokeAndWait(
                () -> {
                    assertWhole(made.get(), language);
                    var guide = (JTextArea) named(made.get(), "guide");
                    assertTrue(guide.getText().contains("JSON"), guide.getText());
                    assertFalse(guide.getText().contains(compiles), guide.getText());
                    show(made.get(), BackgroundWork.NONE, Optional.empty());
                    assertTrue(guide.getText().contains(compiles), guide.getText());
                    made.get().close();
                });
    }

    @ParameterizedTest(name = "the heading says that a check runs while a course is joined: {0}")
    @CsvSource({"ENGLISH, Joining the course…", "RUSSIAN, Идёт запись на курс…"})
    void headingSaysThatACourseIsJoined(Language language, String heading) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(language, FAILURES::add);
                    show(pane, BackgroundWork.of(BackgroundWork.Phase.JOINING), Optional.empty());
                    assertEquals(heading, ((JLabel) named(pane, "result.verdict")).getText());
                    pane.close();
                });
    }

    @ParameterizedTest(name = "the heading does not say that the exercise has changed: {0}")
    @CsvSource({
        "ENGLISH, for an earlier version of the exercise",
        "RUSSIAN, по прежней версии задания"
    })
    void headingSaysThatTheExerciseHasChanged(Language language, String words) throws Exception {
        Outcome now = outcome(GradingVerdict.OK);
        Outcome earlier =
                new Outcome(
                        now.source(),
                        2,
                        now.verdict(),
                        now.points(),
                        now.cases(),
                        now.remarks(),
                        now.isolation(),
                        now.nanosPerItem(),
                        true);
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(language, FAILURES::add);
                    for (Outcome one : List.of(now, earlier)) {
                        show(pane, BackgroundWork.NONE, Optional.of(one));
                        String said = ((JLabel) named(pane, "result.where")).getText();
                        assertEquals(one.earlier(), said.contains(words), said);
                    }
                    pane.close();
                });
    }

    @ParameterizedTest(name = "a case that is not judged yet is said to be judged: {0}")
    @CsvSource({
        "ENGLISH, '', not judged yet",
        "RUSSIAN, '', ещё не проверен",
        "ENGLISH, wrong, not judged yet",
        "RUSSIAN, wrong, ещё не проверен"
    })
    void saysWhatIsStillToComeOfACase(Language language, String verdict, String words)
            throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(language, FAILURES::add);
                    CaseResult tried = judged(CaseResult.untried(EXERCISE).get(0), verdict);
                    var grading =
                            new BackgroundWork(BackgroundWork.Phase.GRADING, 1, 0, List.of(tried));
                    show(pane, grading, Optional.empty());
                    ((JTable) named(pane, "cases")).setRowSelectionInterval(0, 0);
                    String said = ((JTextArea) named(pane, "reason")).getText();
                    assertTrue(said.contains(words), said);
                    pane.close();
                });
    }

    @ParameterizedTest(
            name = "a hyphen stands for the minus of a pixel, or in what was thrown: {0}")
    @CsvSource({
        "ENGLISH, 'pixel (−3, 4) is missing, (−2, −5) is drawn'",
        "RUSSIAN, 'нет пикселя (−3; 4), нарисован (−2; −5)'"
    })
    void coordinatesHaveAMinus(Language language, String words) throws Exception {
        Message said =
                Message.of("pixel.instead", "(-3, 4)", "(-2, -5)").and(Message.quoted("x (-1, 2)"));
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(language, FAILURES::add);
                    CaseResult open = CaseResult.untried(EXERCISE).get(0);
                    var wrong =
                            new CaseResult(
                                    open.name(),
                                    "wrong",
                                    0,
                                    open.of(),
                                    LocalizedText.of(said::in),
                                    List.of(),
                                    "");
                    Outcome plain = outcome(GradingVerdict.WRONG);
                    var result =
                            new Outcome(
                                    plain.source(),
                                    0,
                                    plain.verdict(),
                                    plain.points(),
                                    List.of(wrong),
                                    List.of(),
                                    plain.isolation(),
                                    0,
                                    false);
                    show(pane, BackgroundWork.NONE, Optional.of(result));
                    ((JTable) named(pane, "cases")).setRowSelectionInterval(0, 0);
                    assertEquals(
                            words + "; x (-1, 2)", ((JTextArea) named(pane, "reason")).getText());
                    pane.close();
                });
    }

    private static void assertWhole(ResultPane pane, Language language) {
        var scroll = (JScrollPane) named(pane, "guide.scroll");
        var guide = (JTextArea) named(pane, "guide");
        assertTrue(scroll.isVisible());
        assertTrue(guide.getText().contains("Ctrl+Enter"), guide.getText());
        String check = Texts.of("exercise", language).label("check");
        assertTrue(guide.getText().contains(check), guide.getText());
        assertTrue(
                guide.getPreferredSize().height <= scroll.getViewport().getHeight(),
                guide.getPreferredSize().height + " in " + scroll.getViewport().getHeight());
        assertFalse(named(pane, "case.picture").isVisible());
    }
}
