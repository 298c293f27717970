package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.image.BufferedImage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RulersTest {
    private static final Dimension VIEW = new Dimension(200, 100);
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "number is left out though there is room, 60, true",
        "number is cut by the upper margin, 27, false",
        "number is cut by the lower edge, 97, false",
    })
    void numbersAreWholeOrNotThere(String mistake, int viewY, boolean there) {
        assertEquals(there, numberAt(viewY), mistake);
    }

    /** Whether the left margin has a number for the row whose middle is there. */
    private static boolean numberAt(int viewY) {
        var image = new BufferedImage(VIEW.width, VIEW.height, BufferedImage.TYPE_INT_RGB);
        var g = image.createGraphics();
        new Rulers(new ZoomedGrid(100, viewY, 30), VIEW, StageColors.LIGHT, FONT).paintMargins(g);
        g.dispose();
        int margin = StageColors.LIGHT.margin().getRGB();
        for (int y = Math.max(Rulers.top() + 1, viewY - 9); y < Math.min(100, viewY + 9); y++)
            for (int x = 0; x < Rulers.left(); x++) if (image.getRGB(x, y) != margin) return true;
        return false;
    }
}
