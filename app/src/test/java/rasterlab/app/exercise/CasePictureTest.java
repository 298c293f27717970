package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;

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

    private static byte[] png(int width, int height) throws IOException {
        var bytes = new ByteArrayOutputStream();
        var picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        ImageIO.write(picture, "png", bytes);
        return bytes.toByteArray();
    }
}
