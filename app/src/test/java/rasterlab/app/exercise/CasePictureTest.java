package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class CasePictureTest {
    @Test
    @DisplayName("pictures of two sizes, as another server may send them, end in an unclear error")
    void picturesOfTwoSizesAreToldWithTheirSizes() throws Exception {
        var failures = new ArrayList<Throwable>();
        var pictures = new TriedCase.Pictures(png(9, 9), png(9, 5), png(9, 9), "#");
        EventQueue.invokeAndWait(
                () ->
                        new CasePicture(Texts.of("exercise", Language.ENGLISH), failures::add)
                                .show(Optional.of(pictures)));
        assertEquals(
                List.of("a case's pictures are of 9×9 and 9×5 pixels"),
                failures.stream().map(Throwable::getMessage).toList());
    }

    @ParameterizedTest(name = "a part is not called one: {0}, {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | columns 0..4 of -500..500, rows 7..9 of 0..300"
                        + "| Part: 5 × 3 of 1001 × 301 pixels",
                "RUSSIAN | columns 0..4 of -500..500, rows 7..9 of 0..300"
                        + "| Часть: 5 × 3 из 1001 × 301 пикселей",
                "ENGLISH | '' | ''",
            })
    void aPartIsCalledOne(Language language, String first, String said) throws Exception {
        String text = (first.isEmpty() ? "" : first + "\n") + "#..#.\n.-...\n....+";
        var pictures = new TriedCase.Pictures(png(41, 25), png(41, 25), png(41, 25), text);
        EventQueue.invokeAndWait(
                () -> {
                    var shown = new CasePicture(Texts.of("exercise", language), failure -> {});
                    shown.setSize(600, 300);
                    shown.show(Optional.of(pictures));
                    assertEquals(said, shown.words());
                });
    }

    @Test
    @DisplayName("what a small window shows of a large picture is not called a part")
    void whatHasNoRoomIsLeftOut() throws Exception {
        String row = "#".repeat(80) + "\n";
        byte[] png = png(641, 321);
        var pictures = new TriedCase.Pictures(png, png, png, row.repeat(40).strip());
        EventQueue.invokeAndWait(
                () -> {
                    var shown = new CasePicture(Texts.of("exercise", Language.ENGLISH), one -> {});
                    shown.setSize(400, 130);
                    shown.show(Optional.of(pictures));
                    assertTrue(shown.words().endsWith("of 80 × 40 pixels"), shown.words());
                    shown.setSize(1200, 600);
                    assertEquals("", shown.words());
                });
    }

    private static byte[] png(int width, int height) throws IOException {
        var bytes = new ByteArrayOutputStream();
        var picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        ImageIO.write(picture, "png", bytes);
        return bytes.toByteArray();
    }
}
