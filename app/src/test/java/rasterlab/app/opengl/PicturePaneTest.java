package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;

class PicturePaneTest {
    /** View units. */
    private static final int WIDTH = 210;

    @BeforeAll
    static void lookLikeTheLab() {
        LabTheme.LIGHT.install();
    }

    @ParameterizedTest(name = "the sentence is cut off where there are {0} units for it")
    @CsvSource({"300", "80"})
    void allOfASentenceIsShown(int height) throws InterruptedException {
        String sentence =
                Texts.of("opengl", Language.RUSSIAN)
                        .text("missing", "у EGL нет дисплея без поверхности, а окна нет");
        var pane = new PicturePane("pane", "pane", Optional::empty, () -> sentence, () -> {});
        BufferedImage painted = OffscreenPainter.paint(pane, WIDTH, height);
        int margin = StageColors.LIGHT.margin().getRGB();
        int[] rows =
                IntStream.range(0, height)
                        .filter(
                                y ->
                                        IntStream.range(0, WIDTH)
                                                .anyMatch(x -> painted.getRGB(x, y) != margin))
                        .toArray();
        assertTrue(rows.length > 30, "nothing is said");
        assertEquals(true, rows[rows.length - 1] < height - 4, "down to " + rows[rows.length - 1]);
    }
}
