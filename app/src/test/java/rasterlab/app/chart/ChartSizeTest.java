package rasterlab.app.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.precision.DepthPrecisionChart;

class ChartSizeTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "type does not grow with the window's, 1440, 900, 1.5, 960, 600, 1.5",
        "usual type is made larger on a large stage, 1440, 900, 1, 1440, 900, 1",
        "large type leaves the chart no room, 720, 900, 1.5, 720, 900, 1",
        "a narrow stage cuts the chart, 360, 480, 1, 720, 960, 1",
        "a low stage cuts the chart, 1440, 240, 1, 2880, 480, 1"
    })
    void typeIsTheWindowsAsFarAsThereIsRoom(
            String mistake, int wide, int high, double wanted, int width, int height, double dots) {
        assertEquals(
                new ChartSize(width, height, dots), ChartSize.filling(wide, high, wanted), mistake);
    }

    @Test
    void chartIsLaidOutInItsSize() {
        var size = new ChartSize(720, 480, 1.5);
        var image = DepthPrecisionChart.image(Language.RUSSIAN, ChartLook.PAPER, size);
        assertEquals(1080, image.getWidth());
        assertEquals(720, image.getHeight());
        int inked = 0;
        for (int x = 0; x < 1080; x++)
            for (int y = 700; y < 720; y++) if (image.getRGB(x, y) != -1) inked++;
        assertTrue(inked > 0, "the axis' words are not at the lower edge");
    }
}
