package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;
import static rasterlab.app.exercise.ShownResult.pane;
import static rasterlab.app.exercise.ShownResult.show;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import javax.swing.JTable;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.OutcomeFile;
import rasterlab.app.exercise.outcome.ResultPicture;
import rasterlab.app.exercise.panel.CaseCanvas;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.exercise.panel.SavedExercisePanes;
import rasterlab.app.language.Language;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PictureBytes;

/** Which case of a result is chosen and in sight. */
class CaseChoiceTest {
    private static final List<Throwable> FAILURES = new CopyOnWriteArrayList<>();
    private static final int SMALLEST = 5;
    private static final CaseResult HIDDEN =
            new CaseResult("hidden", "wrong", 0, 4, LocalizedText.NOTHING, List.of(), "");

    private final SavedExercisePanes kept = new SavedExercisePanes();

    @TempDir private Path folder;

    @AfterEach
    void noFailures() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
        assertEquals(List.of(), FAILURES);
    }

    @ParameterizedTest(name = "a pane in {0} chooses the smallest counterexample again")
    @EnumSource
    void chosenCaseStaysInAnotherPane(Language language) throws Exception {
        Optional<Outcome> outcome = Optional.of(wrong());
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane before = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(before, BackgroundWork.NONE, outcome);
                    assertEquals(SMALLEST, cases(before).getSelectedRow());
                    cases(before).setRowSelectionInterval(2, 2);
                    before.close();
                    ResultPane after = pane(language, kept, FAILURES::add);
                    show(after, BackgroundWork.NONE, outcome);
                    assertEquals(2, cases(after).getSelectedRow());
                    after.close();
                });
    }

    @Test
    @DisplayName("the next result is shown by the case that was chosen in the last one")
    void nextResultIsShownByItsSmallestCounterexample() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(pane, BackgroundWork.NONE, Optional.of(wrong()));
                    cases(pane).setRowSelectionInterval(2, 2);
                    show(pane, BackgroundWork.NONE, Optional.of(wrong("another text")));
                    assertEquals(SMALLEST, cases(pane).getSelectedRow());
                    pane.close();
                });
    }

    @Test
    @DisplayName(
            "the choice jumps to the smallest counterexample when the same text is tried again")
    void caseStaysChosenWhileItsTextIsJudgedAgainAndAlike() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(pane, BackgroundWork.NONE, Optional.empty());
                    cases(pane).setRowSelectionInterval(4, 4);
                    show(pane, BackgroundWork.NONE, Optional.of(wrong()));
                    cases(pane).setRowSelectionInterval(2, 2);
                    show(pane, judged(1), Optional.empty());
                    assertEquals(2, cases(pane).getSelectedRow());
                    show(pane, BackgroundWork.NONE, Optional.of(wrong()));
                    assertEquals(2, cases(pane).getSelectedRow());
                    pane.close();
                });
    }

    @Test
    @DisplayName("a case that is judged otherwise by now stays chosen")
    void caseThatHangsIsShownRatherThanOneChosenBefore() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(pane, BackgroundWork.NONE, Optional.of(wrong()));
                    show(
                            pane,
                            BackgroundWork.NONE,
                            Optional.of(ShownResult.outcome(GradingVerdict.TIME_LIMIT)));
                    assertEquals(0, cases(pane).getSelectedRow());
                    pane.close();
                });
    }

    @Test
    @DisplayName("no case is chosen in a result of an earlier run that has no pictures")
    void resultThatIsBroughtBackIsShownByACaseThatWentWrong() throws Exception {
        var file = folder.resolve("result.json");
        OutcomeFile.write(
                file, ShownResult.EXERCISE, ShownResult.outcome(GradingVerdict.RUNTIME_ERROR));
        var restored = OutcomeFile.read(file, ShownResult.EXERCISE);
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(pane, BackgroundWork.NONE, restored);
                    assertEquals(0, cases(pane).getSelectedRow());
                    pane.close();
                });
    }

    @Test
    @DisplayName("no case is chosen in a right result of an earlier run")
    void rightResultIsShownByItsFirstCase() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(
                            pane,
                            BackgroundWork.NONE,
                            Optional.of(ShownResult.outcome(GradingVerdict.OK)));
                    assertEquals(0, cases(pane).getSelectedRow());
                    pane.close();
                });
    }

    @Test
    @DisplayName("another hidden case than the one that was chosen is chosen again")
    void hiddenCasesAreChosenApart() throws Exception {
        Outcome plain = ShownResult.outcome(GradingVerdict.WRONG);
        var outcome =
                new Outcome(
                        "",
                        1,
                        "wrong",
                        plain.points(),
                        List.of(HIDDEN, HIDDEN, HIDDEN),
                        List.of(),
                        LocalizedText.NOTHING,
                        0,
                        false);
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane before = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(before, BackgroundWork.NONE, Optional.of(outcome));
                    cases(before).setRowSelectionInterval(1, 1);
                    before.close();
                    ResultPane after = pane(Language.RUSSIAN, kept, FAILURES::add);
                    show(after, BackgroundWork.NONE, Optional.of(outcome));
                    assertEquals(1, cases(after).getSelectedRow());
                    assertEquals("скрытый 2", cases(after).getValueAt(1, 1));
                    after.close();
                });
    }

    @Test
    @DisplayName("hidden cases share one name while they are graded")
    void hiddenCasesAreToldApartWhileTheyAreGraded() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.RUSSIAN, kept, FAILURES::add);
                    show(pane, grading(HIDDEN, HIDDEN), Optional.empty());
                    assertEquals("скрытый 2", cases(pane).getValueAt(1, 1));
                    cases(pane).setRowSelectionInterval(0, 0);
                    show(pane, grading(HIDDEN, HIDDEN, HIDDEN), Optional.empty());
                    assertEquals(0, cases(pane).getSelectedRow());
                    pane.close();
                });
    }

    private static BackgroundWork grading(CaseResult... cases) {
        return new BackgroundWork(BackgroundWork.Phase.GRADING, cases.length, 0, List.of(cases));
    }

    @Test
    @DisplayName("verdicts are lost before there are others, or do not come back")
    void verdictsStayUntilOthersCome() throws Exception {
        Optional<Outcome> before = Optional.of(wrong());
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(pane, BackgroundWork.NONE, before);
                    show(pane, BackgroundWork.of(BackgroundWork.Phase.JOINING), before);
                    assertEquals("wrong", cases(pane).getValueAt(3, 3));
                    show(
                            pane,
                            new BackgroundWork(BackgroundWork.Phase.CHECKING, 0, 9, List.of()),
                            before);
                    assertEquals("wrong", cases(pane).getValueAt(3, 3));
                    show(pane, judged(1), before);
                    assertEquals("–", cases(pane).getValueAt(3, 3));
                    show(pane, BackgroundWork.NONE, before);
                    assertEquals("wrong", cases(pane).getValueAt(3, 3));
                    pane.close();
                });
    }

    @Test
    @DisplayName("the first cases stay out of sight when there is room for them")
    void listStartsAtItsTopWhereTheChosenCaseIsInSight() throws Exception {
        var made = new AtomicReference<ResultPane>();
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.LIGHT, 14);
                    made.set(pane(Language.RUSSIAN, kept, FAILURES::add));
                    show(made.get(), BackgroundWork.NONE, Optional.of(wrong()));
                });
        OffscreenPainter.paint(made.get(), 775, 140);
        EventQueue.invokeAndWait(() -> assertTrue(seen(made.get(), SMALLEST), "out of sight"));
        OffscreenPainter.paint(made.get(), 775, 335);
        EventQueue.invokeAndWait(
                () -> {
                    assertTrue(seen(made.get(), SMALLEST), "chosen, but out of sight");
                    assertEquals(0, cases(made.get()).getVisibleRect().y);
                    made.get().close();
                });
    }

    @Test
    @DisplayName("the list jumps with every case that is judged")
    void listStaysWhereItIsWhileCasesAreJudged() throws Exception {
        var made = new AtomicReference<ResultPane>();
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    made.set(pane(Language.ENGLISH, kept, FAILURES::add));
                    show(made.get(), judged(1), Optional.empty());
                });
        OffscreenPainter.paint(made.get(), 775, 180);
        EventQueue.invokeAndWait(
                () -> {
                    JTable cases = cases(made.get());
                    cases.setRowSelectionInterval(4, 4);
                    Rectangle seen = cases.getVisibleRect();
                    seen.y = cases.getCellRect(4, 0, true).y;
                    cases.scrollRectToVisible(seen);
                    for (int judged = 2; judged < 5; judged++) {
                        show(made.get(), judged(judged), Optional.empty());
                        assertEquals(seen.y, cases.getVisibleRect().y);
                    }
                    made.get().close();
                });
    }

    @Test
    @DisplayName("a verdict that may still change is shown while the check runs")
    void noVerdictIsShownBeforeAllAreKnown() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.ENGLISH, kept, FAILURES::add);
                    show(pane, judged(4), Optional.empty());
                    assertEquals("–", cases(pane).getValueAt(3, 3));
                    show(pane, BackgroundWork.NONE, Optional.of(wrong()));
                    assertEquals("wrong", cases(pane).getValueAt(3, 3));
                    pane.close();
                });
    }

    @ParameterizedTest(name = "the reason of {0} names a counterexample twice, or none")
    @CsvSource({"upward-goes-down, true", "backwards-other-pixels, false"})
    void aCaseWithACounterexampleOfItsOwnIsNotCalledOneAgain(String smallest, boolean called)
            throws Exception {
        Outcome all = wrong();
        var said = new LocalizedText("it is so", "это так");
        List<CaseResult> cases =
                all.cases().stream()
                        .map(one -> drawn(one, one.name().equals(smallest) ? 1 : 4, said))
                        .toList();
        var outcome =
                new Outcome(
                        "",
                        0,
                        "wrong",
                        all.points(),
                        cases,
                        List.of(),
                        LocalizedText.NOTHING,
                        0,
                        false);
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    ResultPane pane = pane(Language.RUSSIAN, kept, FAILURES::add);
                    show(pane, BackgroundWork.NONE, Optional.of(outcome));
                    String reason = ((JTextArea) named(pane, "reason")).getText();
                    assertEquals(called ? "Наименьший контрпример: это так" : "это так", reason);
                    pane.close();
                });
    }

    private static BackgroundWork judged(int cases) {
        List<CaseResult> all = wrong().cases();
        return new BackgroundWork(
                BackgroundWork.Phase.CHECKING, cases, all.size(), all.subList(0, cases));
    }

    private static JTable cases(ResultPane pane) {
        return (JTable) named(pane, "cases");
    }

    private static boolean seen(ResultPane pane, int row) {
        JTable cases = cases(pane);
        return cases.getVisibleRect().contains(cases.getCellRect(row, 0, false));
    }

    /** Every case is drawn wrong, that of one row in the fewest pixels. */
    private static Outcome wrong() {
        return wrong("");
    }

    private static Outcome wrong(String source) {
        Outcome plain = ShownResult.outcome(GradingVerdict.WRONG);
        List<CaseResult> cases =
                plain.cases().stream()
                        .map(one -> drawn(one, plain.cases().indexOf(one) == SMALLEST ? 1 : 4))
                        .toList();
        return new Outcome(
                source,
                0,
                plain.verdict(),
                plain.points(),
                cases,
                List.of(),
                LocalizedText.NOTHING,
                0,
                false);
    }

    private static CaseResult drawn(CaseResult one, int pixels) {
        return drawn(one, pixels, LocalizedText.NOTHING);
    }

    private static CaseResult drawn(CaseResult one, int pixels, LocalizedText said) {
        byte[] png = png(pixels);
        var rows = new LocalizedText("-".repeat(pixels), "-".repeat(pixels));
        List<ResultPicture> pictures =
                CaseCanvas.USUAL.stream()
                        .map(
                                kind ->
                                        new ResultPicture(
                                                kind,
                                                PictureBytes.alike(png),
                                                rows,
                                                Optional.empty()))
                        .toList();
        return new CaseResult(one.name(), one.verdict(), 0, one.of(), said, pictures, "");
    }

    private static byte[] png(int width) {
        var bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(new BufferedImage(width, 1, BufferedImage.TYPE_INT_RGB), "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
