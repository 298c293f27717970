package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.Base64;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class SvgPictureTest {
    private static final Pattern SHARP = Pattern.compile("image-rendering: *pixelated");

    private static final Pattern PNG = Pattern.compile("data:image/png;base64,([^\"]+)");

    @Test
    @DisplayName("a picture that changes until the document is written is in it as it became")
    void pictureIsThatOfTheMomentWhenItWasDrawn() throws Exception {
        var picture = new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(1, 1, 0xFFC06030);
        SvgDrawing drawing = SvgPicture.of(10, 10, g -> g.drawImage(picture, 0, 0, null));
        picture.setRGB(1, 1, 0xFF000000);
        Matcher png = PNG.matcher(drawing.document());
        assertTrue(png.find(), "no picture");
        byte[] bytes = Base64.getMimeDecoder().decode(png.group(1).replace("&#10;", ""));
        BufferedImage kept = ImageIO.read(new ByteArrayInputStream(bytes));
        assertEquals(0xFFC06030, kept.getRGB(1, 1));
    }

    @Test
    @DisplayName("viewers smooth the edges between pixels away")
    void onlyAnEnlargedPictureKeepsItsSquares() {
        var picture = new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB);
        String enlarged =
                SvgPicture.of(90, 60, g -> g.drawImage(picture, 0, 0, 90, 60, null)).document();
        assertTrue(SHARP.matcher(enlarged).find(), enlarged);
        String plain = SvgPicture.of(90, 60, g -> g.drawImage(picture, 0, 0, null)).document();
        assertFalse(SHARP.matcher(plain).find(), plain);
    }

    @Test
    @DisplayName("what any thread may draw is drawn on the thread that asks for the drawing")
    void laterDrawingIsDrawnByWhoWritesTheDocument() throws Exception {
        var drawers = new CopyOnWriteArrayList<Thread>();
        SvgDrawing drawing = SvgPicture.later(10, 10, g -> drawers.add(Thread.currentThread()));
        var writer = new Thread(drawing::document);
        writer.start();
        writer.join();
        assertEquals(java.util.List.of(writer), drawers);
    }
}
