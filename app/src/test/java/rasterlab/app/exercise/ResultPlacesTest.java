package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;
import static rasterlab.app.exercise.ShownResult.outcome;
import static rasterlab.app.exercise.ShownResult.pane;
import static rasterlab.app.exercise.ShownResult.show;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.panel.CaseCanvas;
import rasterlab.app.exercise.panel.CaseTable;
import rasterlab.app.exercise.panel.PlacedCase;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.language.Language;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Where table, reason and pictures stand before a check and after it. */
class ResultPlacesTest {
    private static final List<Throwable> FAILURES = new CopyOnWriteArrayList<>();

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
        assertEquals(List.of(), FAILURES);
    }

    /** The sizes are those of windows of 900×600, 1280×800 and 1920×1080. */
    @ParameterizedTest(name = "the table moves when its cases are checked: {0}, {1}×{2}")
    @CsvSource({
        "ENGLISH, 870, 440",
        "RUSSIAN, 870, 440",
        "ENGLISH, 775, 335",
        "RUSSIAN, 775, 335",
        "ENGLISH, 1170, 475",
        "RUSSIAN, 1170, 475"
    })
    void tableStaysWhateverTheVerdicts(Language language, int width, int height) throws Exception {
        var made = new AtomicReference<ResultPane>();
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.LIGHT, 14);
                    made.set(pane(language, FAILURES::add));
                    show(made.get(), BackgroundWork.NONE, Optional.empty());
                });
        ResultPane pane = made.get();
        OffscreenPainter.paint(pane, width, height);
        Rectangle before = named(pane, "cases.scroll").getBounds();
        Rectangle guide = named(pane, "guide.scroll").getBounds();
        for (GradingVerdict verdict : EnumSet.complementOf(EnumSet.copyOf(CaseTable.OF_NO_CASE))) {
            EventQueue.invokeAndWait(
                    () -> show(pane, BackgroundWork.NONE, Optional.of(outcome(verdict))));
            OffscreenPainter.paint(pane, width, height);
            Rectangle after = named(pane, "cases.scroll").getBounds();
            // The line above may wrap, by which the table is lower.
            assertEquals(before.getLocation(), after.getLocation(), verdict.code());
            assertEquals(before.width, after.width, verdict.code());
            assertEquals(guide.x, named(pane, "case.picture").getX(), verdict.code());
            int columns = ((JTable) named(pane, "cases")).getColumnCount();
            assertEquals(4, columns, verdict.code() + " is not said in words");
        }
        assertUseful(pane);
        EventQueue.invokeAndWait(pane::close);
    }

    /** The sizes are those of a window of 1280×800 at 125, 150, 175 and 200 %. */
    @ParameterizedTest(name = "verdicts or pictures have no room: {0}, projector, type of {1}")
    @CsvSource({
        "ENGLISH, 24, 1250, 630",
        "RUSSIAN, 24, 1250, 630",
        "ENGLISH, 33, 1250, 545",
        "RUSSIAN, 33, 1250, 545",
        "ENGLISH, 28, 1250, 590",
        "RUSSIAN, 28, 1250, 590",
        "ENGLISH, 38, 1250, 500",
        "RUSSIAN, 38, 1250, 500"
    })
    void projectorShowsVerdictsAndPictures(Language language, double type, int width, int height)
            throws Exception {
        var made = new AtomicReference<ResultPane>();
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.PROJECTOR, type);
                    made.set(pane(language, FAILURES::add));
                    show(made.get(), BackgroundWork.NONE, Optional.of(explained()));
                });
        ResultPane pane = made.get();
        for (int round = 0; round < 2; round++) OffscreenPainter.paint(pane, width, height);
        assertEquals(4, ((JTable) named(pane, "cases")).getColumnCount(), "no verdicts");
        var picture = (CaseCanvas) named(pane, "case.picture");
        assertTrue(picture.together(), "no room for three pictures in " + picture.getSize());
        assertTrue(picture.getHeight() >= 120, "pictures are high by " + picture.getHeight());
        PlacedCase placed = picture.arranged(CaseCanvas.USUAL).orElseThrow();
        float names = placed.pictures().type().getSize2D();
        float cases = named(pane, "cases").getFont().getSize2D();
        assertTrue(cases >= 0.7 * type, "cases of " + cases + " beside type of " + type);
        assertTrue(names >= 0.7 * cases, "names of " + names + " beside cases of " + cases);
        Component open = named(pane, "open");
        assertTrue(
                open.getParent().getY() + open.getY() + open.getHeight()
                        <= open.getParent().getParent().getHeight(),
                "the button is cut");
        EventQueue.invokeAndWait(pane::close);
    }

    /** Each case is wrong for one reason, as long as most are. */
    private static Outcome explained() {
        Message said =
                Message.of("pixel.instead", "(-12, 34)", "(-12, 35)")
                        .and(Message.of("known-fault", "bresenham-textbook"));
        Outcome plain = outcome(GradingVerdict.WRONG);
        List<CaseResult> cases =
                plain.cases().stream()
                        .map(
                                one ->
                                        new CaseResult(
                                                one.name(),
                                                one.verdict(),
                                                0,
                                                one.of(),
                                                LocalizedText.of(said::in),
                                                List.of(),
                                                ""))
                        .toList();
        return new Outcome(
                "",
                0,
                plain.verdict(),
                plain.points(),
                cases,
                List.of(),
                LocalizedText.NOTHING,
                0,
                false);
    }

    @Test
    @DisplayName("labels of the head keep the sizes of another type")
    void headIsPlacedInItsOwnType() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.PROJECTOR, 38);
                    ResultPane pane = pane(Language.ENGLISH, FAILURES::add);
                    show(pane, BackgroundWork.NONE, Optional.of(outcome(GradingVerdict.WRONG)));
                    pane.setSize(1250, 500);
                    layOutOnce(pane);
                    for (String name : List.of("result.verdict", "result.points")) {
                        Component label = named(pane, name);
                        assertEquals(label.getPreferredSize(), label.getSize(), name);
                    }
                    pane.close();
                });
    }

    private static void layOutOnce(Container container) {
        container.doLayout();
        for (Component child : container.getComponents())
            if (child instanceof Container inner) layOutOnce(inner);
    }

    private static void assertUseful(ResultPane pane) {
        var picture = (CaseCanvas) named(pane, "case.picture");
        assertTrue(picture.together(), "no room for three pictures in " + picture.getSize());
        assertTrue(picture.getHeight() >= 120, "pictures are high by " + picture.getHeight());
        var table = (JTable) named(pane, "cases");
        int rows = table.getParent().getHeight() / table.getRowHeight();
        assertTrue(rows >= 9, rows + " rows are seen");
    }
}
