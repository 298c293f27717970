package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;

/** Wrong pixels on the greys of the picture that shows them, the same in every theme. */
class DifferenceContrastTest {
    private static final double LEAST = 3;
    private static final int SIDE = 9;
    private static final int MIDDLE = SIDE / 2;

    @ParameterizedTest(name = "a wrong pixel is lost on grey {0}")
    @ValueSource(ints = {0, 60, 128, 200, 255})
    void wrongPixelStandsOutFromItsEdgeAndThatFromTheGround(int level) {
        Raster mask = PictureDifference.of(gray(level, 0), gray(level, 1)).mask();
        Color wrong = at(mask, MIDDLE, MIDDLE);
        assertEquals(PictureDifference.WRONG, wrong.getRGB());
        Color ground = at(mask, 0, 0);
        for (int dx = -1; dx <= 1; dx++)
            for (int dy = -1; dy <= 1; dy++) {
                if (dx == 0 && dy == 0) continue;
                Color edge = at(mask, MIDDLE + dx, MIDDLE + dy);
                requireContrast(wrong, edge);
                requireContrast(edge, ground);
            }
    }

    private static void requireContrast(Color one, Color other) {
        double contrast = MethodColors.contrast(one, other);
        assertTrue(contrast >= LEAST, one + " on " + other + ": " + contrast);
    }

    private static Color at(Raster mask, int x, int y) {
        return new Color(mask.argb(x, y));
    }

    /**
     * @param middle what the blue of the pixel in the middle differs by
     */
    private static Raster gray(int level, int middle) {
        var raster = new Raster(SIDE, SIDE);
        int argb = 0xFF000000 | 0x010101 * level;
        raster.clear(argb);
        raster.argb()[MIDDLE * SIDE + MIDDLE] = argb ^ middle;
        return raster;
    }
}
