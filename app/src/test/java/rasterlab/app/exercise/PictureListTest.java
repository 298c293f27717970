package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.FittedPicture;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.ResultPicture;
import rasterlab.app.exercise.panel.CaseCanvas;
import rasterlab.app.exercise.panel.CaseTable;
import rasterlab.app.exercise.panel.PlacedCase;
import rasterlab.app.exercise.panel.ResultPane;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PictureBytes;

/** Cases whose pictures are others than three grids of pixels. */
class PictureListTest {
    private static final LocalizedText WORDS = new LocalizedText("a triangle", "треугольник");

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @Test
    @DisplayName("a drawing is cut or enlarged like a grid of pixels where it has little room")
    void aDrawingIsShownWholeInItsShape() throws Exception {
        onCanvas(
                List.of(drawing("expected", 640, 320), drawing("actual", 640, 320)),
                canvas -> {
                    for (var size : List.of(new Dimension(300, 130), new Dimension(1500, 700))) {
                        canvas.setSize(size);
                        PlacedCase placed = canvas.arranged(List.of("expected")).orElseThrow();
                        Rectangle place = placed.pictures().places().get(0);
                        assertEquals(2, (double) place.width / place.height, 0.1, place::toString);
                        assertEquals(List.of(), placed.words());
                        assertTrue(place.height > 0.7 * size.height, place::toString);
                    }
                });
    }

    @Test
    @DisplayName("a drawing is distorted to the shape of its place")
    void aDrawingKeepsItsShape() {
        var picture = new FittedPicture(new BufferedImage(400, 100, BufferedImage.TYPE_INT_RGB));
        assertEquals(
                new Rectangle(10, 75, 200, 50), picture.fitted(new Rectangle(10, 0, 200, 200)));
        assertEquals(
                new Rectangle(0, 45, 1000, 250), picture.fitted(new Rectangle(0, 0, 1000, 340)));
    }

    @Test
    @DisplayName("a thin line is lost where a drawing is shown small")
    void aThinLineStaysInASmallDrawing() {
        var large = new BufferedImage(801, 801, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = large.createGraphics();
        g.setColor(Color.WHITE);
        g.drawLine(402, 0, 402, 800);
        g.dispose();
        var small = new BufferedImage(100, 100, BufferedImage.TYPE_INT_RGB);
        g = small.createGraphics();
        var place = new Rectangle(0, 0, 100, 100);
        new FittedPicture(large).paint(g, place, place);
        g.dispose();
        int brightest =
                IntStream.range(0, 100).map(x -> small.getRGB(x, 50) & 255).max().orElseThrow();
        assertTrue(brightest >= 12, "at most " + brightest);
    }

    @Test
    @DisplayName("a picture of a kind that is not known is left out or has no name")
    void aKindThatIsNotKnownIsShownUnderItsOwnName() throws Exception {
        List<ResultPicture> pictures =
                Stream.concat(Stream.of(drawing("light-from", 90, 90)), grids("#-", "#+").stream())
                        .toList();
        onCanvas(
                pictures,
                canvas -> {
                    assertEquals(
                            List.of(
                                    "together",
                                    "light-from",
                                    "expected",
                                    "actual",
                                    "difference",
                                    "blink"),
                            canvas.views());
                    assertEquals("light-from", canvas.nameOf("light-from"));
                    assertEquals("Ожидалось", canvas.nameOf("expected"));
                    assertEquals(
                            "light-from: треугольник\n#-",
                            canvas.getAccessibleContext().getAccessibleDescription());
                    canvas.setSize(900, 300);
                    assertTrue(canvas.together());
                    Graphics2D g =
                            new BufferedImage(900, 300, BufferedImage.TYPE_INT_RGB)
                                    .createGraphics();
                    canvas.paint(g);
                    g.dispose();
                });
    }

    @Test
    @DisplayName("a view is offered of pictures that are not there, or the user's choice is lost")
    void whatCanBeChosenFollowsTheCase() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.LIGHT, 14);
                    ResultPane pane = ShownResult.pane(Language.RUSSIAN, failure -> {});
                    ShownResult.show(pane, BackgroundWork.NONE, Optional.of(twoCases()));
                    var canvas = (CaseCanvas) ShownResult.named(pane, "case.picture");
                    var view = (NameChooser) ShownResult.named(pane, "view");
                    CaseTable table = (CaseTable) ShownResult.named(pane, "cases");
                    table.choose("grids");
                    view.setSelectedItem("blink");
                    assertEquals("expected", canvas.seen());
                    table.choose("drawn");
                    assertEquals(List.of("together", "input", "expected"), offered(view));
                    assertEquals("together", view.getSelectedItem());
                    assertEquals("together", canvas.seen());
                    table.choose("grids");
                    assertEquals("blink", view.getSelectedItem());
                    pane.close();
                });
    }

    private static List<String> offered(NameChooser view) {
        return IntStream.range(0, view.getItemCount()).mapToObj(view::getItemAt).toList();
    }

    private static Outcome twoCases() {
        Outcome plain = ShownResult.outcome(GradingVerdict.WRONG);
        var cases =
                List.of(
                        tried("grids", grids("#-", "#+")),
                        tried("drawn", List.of(drawing("input", 9, 9), drawing("expected", 9, 5))));
        return new Outcome(
                "", 0, plain.verdict(), plain.points(), cases, List.of(), WORDS, 0, false);
    }

    private static CaseResult tried(String name, List<ResultPicture> pictures) {
        return new CaseResult(name, "wrong", 0, 1, LocalizedText.NOTHING, pictures, "");
    }

    private static void onCanvas(List<ResultPicture> pictures, Consumer<CaseCanvas> test)
            throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.LIGHT, 14);
                    var canvas =
                            new CaseCanvas(
                                    Texts.of("exercise", Language.RUSSIAN),
                                    failure -> {
                                        throw new AssertionError(failure);
                                    });
                    canvas.show(pictures);
                    test.accept(canvas);
                });
    }

    /** Shows two pixels, each of 8 dots. */
    private static List<ResultPicture> grids(String difference, String others) {
        return List.of(
                grid("expected", others), grid("actual", others), grid("difference", difference));
    }

    private static ResultPicture grid(String kind, String row) {
        return new ResultPicture(
                kind,
                PictureBytes.alike(png(17, 9)),
                new LocalizedText(row, row),
                Optional.empty());
    }

    private static ResultPicture drawing(String kind, int width, int height) {
        return new ResultPicture(
                kind, PictureBytes.alike(png(width, height)), WORDS, Optional.empty());
    }

    private static byte[] png(int width, int height) {
        var bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(
                    new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
