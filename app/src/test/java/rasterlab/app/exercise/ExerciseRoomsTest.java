package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.FontMetrics;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.panel.ExercisePanel;
import rasterlab.app.exercise.panel.WindowEditor;
import rasterlab.app.language.Language;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.catalogue.Catalogue;

/** Exercises after a check of the starter, which draws nearly every case wrong. */
@Tag("slow")
class ExerciseRoomsTest {
    private static final int LEAST_PICTURE = 120;
    private static final int VERDICT = 3;

    private static final List<Throwable> FAILURES = new CopyOnWriteArrayList<>();
    private static ExerciseLabModel model;

    @BeforeAll
    static void check() throws Exception {
        var ended = new CountDownLatch(1);
        EventQueue.invokeAndWait(
                () -> {
                    model =
                            new ExerciseLabModel(
                                    () -> Catalogue.builtIn().all(),
                                    EventQueue::invokeLater,
                                    FAILURES::add);
                    model.listen(
                            state -> {
                                if (state.outcome().isPresent() && !state.work().running())
                                    ended.countDown();
                            });
                    model.check();
                });
        assertTrue(ended.await(2, TimeUnit.MINUTES), "the check does not end");
    }

    @AfterAll
    static void close() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model.close();
                    LabTheme.LIGHT.install();
                });
        assertEquals(List.of(), FAILURES);
    }

    @ParameterizedTest(name = "a case cannot be read or seen: {0}, {1}, type of {2} in {3}×{4}")
    @CsvSource({
        "RUSSIAN, LIGHT, 14, 900, 538",
        "ENGLISH, LIGHT, 14, 900, 538",
        "RUSSIAN, LIGHT, 21, 900, 538",
        "ENGLISH, DARK, 21, 900, 538",
        "RUSSIAN, PROJECTOR, 19, 900, 538",
        "RUSSIAN, LIGHT, 14, 1280, 738",
        "ENGLISH, LIGHT, 14, 1280, 738",
        "RUSSIAN, PROJECTOR, 19, 1280, 738",
        "RUSSIAN, LIGHT, 21, 1280, 738",
        "RUSSIAN, LIGHT, 21, 2560, 1378"
    })
    void everyCaseIsReadWholeAndItsPictureSeen(
            Language language, LabTheme theme, double type, int width, int height)
            throws Exception {
        ExercisePanel panel = filled(language, theme, type);
        OffscreenPainter.paint(panel, width, height);
        OffscreenPainter.paint(panel, width, height);
        var faults = new ArrayList<String>();
        EventQueue.invokeAndWait(() -> look(panel, faults));
        EventQueue.invokeAndWait(panel::close);
        assertEquals(List.of(), faults);
    }

    @Test
    @DisplayName("a part of the window stays empty below the program")
    void theProgramHasAllTheHeight() throws Exception {
        ExercisePanel panel = filled(Language.ENGLISH, LabTheme.LIGHT, 14);
        OffscreenPainter.paint(panel, 1600, 959);
        OffscreenPainter.paint(panel, 1600, 959);
        EventQueue.invokeAndWait(
                () -> {
                    var above = ((JSplitPane) named(panel, "split.result")).getTopComponent();
                    Component program = named(panel, "source.scroll");
                    Point end = new Point(0, program.getHeight());
                    int left =
                            above.getHeight() - SwingUtilities.convertPoint(program, end, above).y;
                    assertTrue(left < 24, left + " units of " + above.getHeight());
                    panel.close();
                });
    }

    private static ExercisePanel filled(Language language, LabTheme theme, double type)
            throws Exception {
        var made = new AtomicReference<ExercisePanel>();
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(theme, type);
                    made.set(
                            new ExercisePanel(
                                    model,
                                    new WindowEditor(),
                                    ShownResult.NOWHERE,
                                    language,
                                    FAILURES::add));
                    made.get().parts().forEach(Runnable::run);
                    made.get().refresh();
                });
        return made.get();
    }

    @ParameterizedTest(name = "buttons wrap, or the last row in sight is cut: {0}, {1} high")
    @CsvSource({
        "ENGLISH, 760",
        "RUSSIAN, 760",
        "ENGLISH, 728",
        "RUSSIAN, 728",
        "ENGLISH, 650",
        "ENGLISH, 660"
    })
    void usualWindowHasOneRowOfButtonsAndWholeRowsOfCases(Language language, int height)
            throws Exception {
        ExercisePanel panel = filled(language, LabTheme.LIGHT, 14);
        OffscreenPainter.paint(panel, 1280, height);
        OffscreenPainter.paint(panel, 1280, height);
        assertEquals(named(panel, "check").getY(), named(panel, "larger").getParent().getY());
        assertEquals(0, named(panel, "larger").getY());
        var table = (JTable) named(panel, "cases");
        int seen = ((JScrollPane) named(panel, "cases.scroll")).getViewport().getHeight();
        int all = table.getRowCount() * table.getRowHeight();
        assertTrue(all > 0, "no cases");
        assertTrue(seen >= all || seen % table.getRowHeight() == 0, seen + " of " + all);
        EventQueue.invokeAndWait(panel::close);
    }

    private static void look(ExercisePanel panel, List<String> faults) {
        var table = (JTable) named(panel, "cases");
        if (table.getRowCount() == 0) faults.add("no cases");
        if (table.getColumnCount() <= VERDICT) faults.add("no verdicts in words");
        FontMetrics metrics = table.getFontMetrics(table.getFont());
        for (int row = 0; row < table.getRowCount(); row++) {
            if (table.getValueAt(row, 0).toString().isBlank()) faults.add("no sign in row " + row);
            for (int column = 0; column < table.getColumnCount(); column++) {
                String text = String.valueOf(table.getValueAt(row, column));
                if (metrics.stringWidth(text) + 6 > table.getCellRect(row, column, true).width)
                    faults.add(text + " is cut off");
            }
        }
        Component picture = named(panel, "case.picture");
        if (Math.min(picture.getWidth(), picture.getHeight()) < LEAST_PICTURE)
            faults.add("the picture is " + picture.getWidth() + "×" + picture.getHeight());
        Component result = named(panel, "cases.scroll").getParent().getParent().getParent();
        for (Component each : ((Container) result).getComponents())
            if (each.getX() + each.getWidth() > result.getWidth())
                faults.add(each + " is wider than the result");
        var page = (JScrollPane) named(panel, "statement.scroll");
        if (page.getViewport().getView().getWidth() > page.getViewport().getWidth())
            faults.add("the statement is wider than its place");
    }
}
