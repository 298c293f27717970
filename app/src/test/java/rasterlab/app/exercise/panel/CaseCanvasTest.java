package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.exercise.ShownResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.ResultPicture;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.exercises.score.PictureBytes;
import rasterlab.exercises.score.PicturePart;

class CaseCanvasTest {
    private static final String LARGE = ("#".repeat(80) + "\n").repeat(40).strip();

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @Test
    @DisplayName("pictures of two sizes, as another server may send them, end in an unclear error")
    void picturesOfTwoSizesAreToldWithTheirSizes() throws Exception {
        var failures = new ArrayList<Throwable>();
        List<ResultPicture> pictures =
                pictures("#", Optional.empty(), png(9, 9), png(9, 5), png(9, 9));
        EventQueue.invokeAndWait(
                () ->
                        new CaseCanvas(Texts.of("exercise", Language.ENGLISH), failures::add)
                                .show(pictures));
        assertEquals(
                List.of("a case's pictures are of 9×9 and 9×5 pixels"),
                failures.stream().map(Throwable::getMessage).toList());
    }

    @ParameterizedTest(name = "the window does not say which columns and rows a part is: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | A part: columns 0..4 of −500..500, rows 7..9 of 0..300",
                "RUSSIAN | Часть: столбцы 0..4 из −500..500, строки 7..9 из 0..300"
            })
    void aPartIsCalledOne(Language language, String said) throws Exception {
        var part =
                new PicturePart(
                        new PixelWindow(0, 7, 4, 9),
                        new PixelWindow(-500, 0, 500, 300),
                        new Pixel(1, 8));
        String text = "columns and rows\n#..#.\n.-...\n....+";
        EventQueue.invokeAndWait(
                () -> {
                    CaseCanvas shown = shown(language, pictures(text, part, png(41, 25)));
                    shown.setSize(600, 300);
                    assertEquals(List.of(said), words(shown));
                    String told = shown.getAccessibleContext().getAccessibleDescription();
                    assertEquals(said + "\n#..#.\n.-...\n....+", told);
                });
    }

    @Test
    @DisplayName("what a small window shows of a large picture is not called a part")
    void whatHasNoRoomIsLeftOut() throws Exception {
        var whole = new PixelWindow(10, 0, 89, 39);
        var part = new PicturePart(whole, whole, new Pixel(80, 35));
        EventQueue.invokeAndWait(
                () -> {
                    CaseCanvas shown = shown(Language.ENGLISH, pictures(LARGE, part, png()));
                    shown.setSize(400, 130);
                    String said = String.join(" ", words(shown));
                    assertTrue(said.matches("A part: columns .* of 10..89, rows .*"), said);
                    shown.setSize(1200, 600);
                    assertEquals(List.of(), words(shown));
                });
    }

    @ParameterizedTest(name = "a small window shows another place than the message names: {0}, {1}")
    @CsvSource({"80, 35", "10, 0", "50, 20"})
    void thePixelOfTheMessageIsSeen(int x, int y) throws Exception {
        var whole = new PixelWindow(10, 0, 89, 39);
        var part = new PicturePart(whole, whole, new Pixel(x, y));
        EventQueue.invokeAndWait(
                () -> {
                    CaseCanvas shown = shown(Language.ENGLISH, pictures(LARGE, part, png()));
                    shown.setSize(400, 130);
                    Rectangle seen = shown.arranged(CaseCanvas.USUAL).orElseThrow().part();
                    assertTrue(seen.contains(x - 10, y), seen::toString);
                });
    }

    @ParameterizedTest(name = "the words on a part are cut or tiny beside a list: {0}")
    @EnumSource
    void wordsOnAPartAreWhole(Language language) throws Exception {
        var everything = PixelWindow.EVERYTHING;
        var shown = new PixelWindow(Integer.MIN_VALUE, Integer.MIN_VALUE, -2147483569, -2147483609);
        var part = new PicturePart(shown, everything, new Pixel(-2147483600, -2147483640));
        EventQueue.invokeAndWait(
                () -> {
                    CaseCanvas picture =
                            shown(language, pictures("columns\n" + LARGE, part, png()));
                    picture.setSize(300, 260);
                    List<String> lines = words(picture);
                    var metrics = picture.getFontMetrics(picture.getFont());
                    for (String line : lines)
                        assertTrue(metrics.stringWidth(line) <= 300, () -> "cut: " + line);
                    String all = String.join(" ", lines).replaceAll("[-−]?\\d{10}", "#");
                    assertTrue(all.matches(".* #..# (of|из) #..#, .* #..# (of|из) #..#"), all);
                    PlacedCase placed = picture.arranged(CaseCanvas.USUAL).orElseThrow();
                    int lowest =
                            placed.pictures().places().stream()
                                    .mapToInt(place -> place.y + place.height)
                                    .max()
                                    .orElseThrow();
                    int below = (1 + lines.size()) * metrics.getHeight();
                    assertTrue(lowest + below <= 260, lowest + " and " + below);
                });
    }

    private static List<String> words(CaseCanvas shown) {
        return shown.arranged(CaseCanvas.USUAL).orElseThrow().words();
    }

    private static CaseCanvas shown(Language language, List<ResultPicture> pictures) {
        ShownResult.install(LabTheme.LIGHT, 14);
        var shown = new CaseCanvas(Texts.of("exercise", language), failure -> {});
        shown.setFont(UIManager.getFont("Label.font"));
        shown.show(pictures);
        return shown;
    }

    private static List<ResultPicture> pictures(String text, PicturePart part, byte[] png) {
        return pictures(text, Optional.of(part), png, png, png);
    }

    /** One of each kind. */
    private static List<ResultPicture> pictures(
            String text, Optional<PicturePart> part, byte[]... pngs) {
        return IntStream.range(0, pngs.length)
                .mapToObj(
                        i ->
                                new ResultPicture(
                                        CaseCanvas.USUAL.get(i),
                                        PictureBytes.alike(pngs[i]),
                                        new LocalizedText(text, text),
                                        part))
                .toList();
    }

    /** The bytes of a picture of 80 × 40 pixels. */
    private static byte[] png() {
        return png(641, 321);
    }

    private static byte[] png(int width, int height) {
        var bytes = new ByteArrayOutputStream();
        var picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        try {
            ImageIO.write(picture, "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
