package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Font;
import java.awt.image.BufferedImage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class OldPictureTest {
    private static final int WIDTH = 300;
    private static final int HEIGHT = 300;

    @ParameterizedTest(name = "what is waited for runs out of a narrow stage in {0}")
    @EnumSource
    void theSentenceStaysWithinANarrowStage(Language language) {
        var veil = new OldPicture(Texts.of("canvas", language));
        veil.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 24));
        veil.setSize(WIDTH, HEIGHT);
        var image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_ARGB);
        veil.paint(image.getGraphics());
        for (int y = 0; y < HEIGHT; y++)
            for (int x : new int[] {0, 1, WIDTH - 2, WIDTH - 1})
                assertEquals(image.getRGB(0, 0), image.getRGB(x, y), "at " + x + ", " + y);
    }
}
