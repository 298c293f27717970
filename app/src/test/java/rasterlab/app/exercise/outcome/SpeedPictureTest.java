package rasterlab.app.exercise.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;
import static rasterlab.app.exercise.ShownResult.outcome;
import static rasterlab.app.exercise.ShownResult.pane;
import static rasterlab.app.exercise.ShownResult.show;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.BackgroundWork;
import rasterlab.app.exercise.ShownResult;
import rasterlab.app.exercise.panel.CaseCanvas;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.study.front.SpeedChart;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.SpeedFigures;

/** The program's point on the topic's chart stands where the line on speed is chosen. */
class SpeedPictureTest {
    private static final List<Throwable> FAILURES = new CopyOnWriteArrayList<>();
    private static final PublishedSpeed SPEED =
            PublishedSpeed.of(
                    "line",
                    new SpeedFigures(
                            2.5,
                            2,
                            0,
                            List.of(
                                    new SpeedFigures.MethodSpeed("dda", 3, 0),
                                    new SpeedFigures.MethodSpeed(
                                            "wu", 12, Double.POSITIVE_INFINITY))));

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
        assertEquals(List.of(), FAILURES);
    }

    private static Outcome measured(Optional<PublishedSpeed> speed) {
        Outcome plain = outcome(GradingVerdict.OK);
        var cases = new ArrayList<>(plain.cases());
        cases.add(new CaseResult("speed", "ok", 10, 10, LocalizedText.NOTHING, List.of(), ""));
        return new Outcome(
                        plain.source(),
                        plain.attempt(),
                        plain.verdict(),
                        plain.points(),
                        cases,
                        plain.remarks(),
                        plain.isolation(),
                        plain.nanosPerItem(),
                        plain.earlier())
                .with(speed);
    }

    @ParameterizedTest(name = "the chart is not told, or where it should not be: {0}, {1}, {2}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | speed | true | my program: 1.25, 0 (exact); dda: 3.00, 0 (exact); wu: 12.00, ∞",
                "RUSSIAN | speed | true | 1,25, 0 (точно); dda: 3,00, 0 (точно); wu: 12,00, ∞",
                "ENGLISH | first | true | ''",
                "ENGLISH | speed | false | ''",
            })
    void lineOnSpeedShowsTheChart(Language language, String chosen, boolean measured, String said)
            throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    ResultPane pane = pane(language, FAILURES::add);
                    Outcome outcome = measured(measured ? Optional.of(SPEED) : Optional.empty());
                    show(pane, BackgroundWork.NONE, Optional.of(outcome));
                    var table = (JTable) named(pane, "cases");
                    int row = chosen.equals("speed") ? table.getRowCount() - 1 : 0;
                    table.setRowSelectionInterval(row, row);
                    var canvas = (CaseCanvas) named(pane, "case.picture");
                    assertEquals(!said.isEmpty(), canvas.views().contains(SpeedPicture.KIND), said);
                    String told = canvas.getAccessibleContext().getAccessibleDescription();
                    if (!said.isEmpty()) assertTrue(told.endsWith(said), told);
                });
    }

    @Test
    void chartFollowsTheTheme() throws Exception {
        var ground = new ArrayList<Color>();
        var picture = new SpeedPicture(new SpeedChart("line", SPEED, Language.ENGLISH));
        for (LabTheme theme : List.of(LabTheme.LIGHT, LabTheme.DARK))
            EventQueue.invokeAndWait(
                    () -> {
                        theme.install();
                        var image = new BufferedImage(640, 420, BufferedImage.TYPE_INT_RGB);
                        picture.paint(
                                image.createGraphics(),
                                new Rectangle(),
                                new Rectangle(0, 0, 640, 420));
                        ground.add(new Color(image.getRGB(2, 2)));
                        assertTrue(colors(image) > 20, "nothing is drawn");
                    });
        assertFalse(ground.get(0).equals(ground.get(1)), ground::toString);
    }

    private static long colors(BufferedImage image) {
        return Arrays.stream(
                        image.getRGB(
                                0,
                                0,
                                image.getWidth(),
                                image.getHeight(),
                                null,
                                0,
                                image.getWidth()))
                .distinct()
                .count();
    }

    /** State that is kept between runs of the window is read as it was written. */
    @Test
    void chartIsKeptWithTheResult(@TempDir Path folder) {
        var file = folder.resolve("result.json");
        OutcomeFile.write(file, ShownResult.EXERCISE, measured(Optional.of(SPEED)));
        assertEquals(
                Optional.of(SPEED),
                OutcomeFile.read(file, ShownResult.EXERCISE).orElseThrow().speed());
    }
}
