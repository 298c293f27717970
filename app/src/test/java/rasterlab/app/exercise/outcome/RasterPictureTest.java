package rasterlab.app.exercise.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.engine.raster.PixelMark;

class RasterPictureTest {
    private static final int DOTS = 8;

    /** Four pixels beside each other, the third of them marked. */
    private static BufferedImage picture(PixelMark mark) {
        var picture = new BufferedImage(4 * DOTS + 1, DOTS + 1, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, picture.getWidth(), picture.getHeight());
        mark.paint(g, 2 * DOTS, 0, DOTS);
        g.dispose();
        return picture;
    }

    @ParameterizedTest(name = "a mark fades where its pixel is three units wide: {0}")
    @EnumSource
    @DisplayName("marks in small pictures")
    void markHasItsColorInSmallPictures(PixelMark mark) {
        RasterPicture picture = RasterPicture.of(picture(mark), new Dimension(4, 1), DOTS);
        var shown = new BufferedImage(9, 3, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = shown.createGraphics();
        picture.paint(g, new Rectangle(1, 0, 3, 1), new Rectangle(0, 0, 9, 3));
        g.dispose();
        for (int x = 0; x < 9; x++)
            for (int y = 0; y < 3; y++)
                assertEquals(
                        x / 3 == 1 ? PixelMark.ARGB : Color.WHITE.getRGB(),
                        shown.getRGB(x, y),
                        "at " + x + ", " + y);
    }

    @Test
    @DisplayName("a pixel that is shown large has blurred edges")
    void largePixelsAreSharp() {
        var two = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        two.setRGB(0, 0, Color.WHITE.getRGB());
        RasterPicture edge = RasterPicture.of(two, new Dimension(2, 1), 1);
        var shown = new BufferedImage(151, 75, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = shown.createGraphics();
        edge.paint(g, new Rectangle(0, 0, 2, 1), new Rectangle(0, 0, 151, 75));
        g.dispose();
        for (int x = 0; x < 151; x++)
            if (x != 75)
                assertEquals(
                        (x < 75 ? Color.WHITE : Color.BLACK).getRGB(),
                        shown.getRGB(x, 30),
                        "at " + x);
    }
}
