package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

class PlatesTest {
    private static final String LONG = "A note that is long. ".repeat(12).strip();

    private final JPanel stage = new JPanel();
    private final Font font = new Font(Font.DIALOG, Font.PLAIN, 18);

    PlatesTest() {
        stage.setSize(420, 500);
    }

    /** The lowest row that the sentence paints. */
    private int painted(String sentence) {
        var image = new BufferedImage(420, 500, BufferedImage.TYPE_INT_ARGB);
        var g = image.createGraphics();
        g.setFont(font);
        Plates.sentence(g, sentence, 420, StageColours.LIGHT);
        g.dispose();
        int last = 0;
        for (int y = 0; y < 500; y++)
            for (int x = 0; x < 420; x++) if (image.getRGB(x, y) != 0) last = y;
        return last;
    }

    @Test
    void pictureBeginsBelowEveryLineOfTheSentence() {
        Rectangle left = Plates.below(LONG, stage, font);
        assertTrue(painted(LONG) > 5 * font.getSize(), "too short to be wrapped");
        assertTrue(left.y > painted(LONG), left.y + " of " + painted(LONG));
        assertEquals(500, left.y + left.height);
    }

    @Test
    void sentenceLeavesAtLeastHalf() {
        int whole = Plates.below("", stage, font).height;
        assertEquals(whole - whole / 2, Plates.below(LONG.repeat(9), stage, font).height);
    }
}
