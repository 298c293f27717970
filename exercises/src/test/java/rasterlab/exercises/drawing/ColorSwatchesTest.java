package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.Arrays;
import java.util.EnumMap;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorSheet;

class ColorSwatchesTest {
    /** A sheet of two colours in all models whose numbers are zeros but for red and green. */
    private static ColorSheet sheet(double... rgb) {
        var models = new EnumMap<ColorModel, double[]>(ColorModel.class);
        for (ColorModel model : ColorModel.values())
            models.put(model, new double[2 * model.size()]);
        models.put(ColorModel.RGB, rgb);
        return new ColorSheet(models);
    }

    @Test
    @DisplayName("the colour that came stands where the right one is wanted")
    void rightIsOnTheLeftAndWhatCameOnTheRight() throws Exception {
        byte[] png = new ColorSwatches(sheet(1, 0, 0, 0, 1, 0), sheet(1, 0, 0, 0, 0, 1)).png();
        BufferedImage drawn = ImageIO.read(new ByteArrayInputStream(png));
        assertEquals(Color.RED.getRGB(), drawn.getRGB(40, 32));
        assertEquals(Color.RED.getRGB(), drawn.getRGB(114, 32));
        assertEquals(Color.GREEN.getRGB(), drawn.getRGB(40, 74));
        assertEquals(Color.BLUE.getRGB(), drawn.getRGB(114, 74));
    }

    @Test
    @DisplayName("a full turn of hue is a mistake, or a grey's hue that is a number is none")
    void numbersAreWrongByMoreThanLevels() {
        double[] gray = {Double.NaN, 0, 0.5};
        assertFalse(ColorSwatches.isWrong(ColorModel.HSV, gray, gray));
        assertTrue(ColorSwatches.isWrong(ColorModel.HSV, gray, new double[] {0, 0, 0.5}));
        assertFalse(
                ColorSwatches.isWrong(
                        ColorModel.HSV, new double[] {359.9, 1, 1}, new double[] {0, 1, 1}));
        double[] off = new double[] {0.5, 0.5, 0.5};
        double[] right = Arrays.copyOf(off, 3);
        off[1] += 0.02;
        assertTrue(ColorSwatches.isWrong(ColorModel.RGB, right, off));
        assertFalse(ColorSwatches.isWrong(ColorModel.RGB, right, new double[] {0.51, 0.5, 0.5}));
    }
}
