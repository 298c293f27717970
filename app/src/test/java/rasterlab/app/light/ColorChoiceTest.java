package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.contract.ColorModel;

class ColorChoiceTest {
    private static ColorChoice rgb(double red, double green, double blue) {
        return ColorChoice.first()
                .with(ColorModel.RGB, 0, red)
                .with(ColorModel.RGB, 1, green)
                .with(ColorModel.RGB, 2, blue);
    }

    @Test
    void allModelsFollowTheSliderThatIsMoved() {
        ColorChoice color = rgb(1, 0.5, 0).with(ColorModel.HSV, 0, 120);
        assertArrayEquals(new double[] {0, 1, 0}, color.in(ColorModel.RGB), 1e-12);
        assertArrayEquals(new double[] {1, 0, 1}, color.in(ColorModel.CMY), 1e-12);
        assertArrayEquals(new double[] {1, 0, 1, 0}, color.in(ColorModel.CMYK), 1e-12);
        assertEquals(0x00FF00, color.rgb());
    }

    @Test
    void movedNumberIsKeptAsItWasWritten() {
        ColorChoice black = rgb(1, 0.5, 0).with(ColorModel.HSV, 2, 0);
        assertEquals(0, black.rgb());
        assertEquals(30, black.in(ColorModel.HSV)[0], 1e-9, "black forgot the hue");
        assertEquals(0xFF8000, black.with(ColorModel.HSV, 2, 1).rgb());
    }

    @Test
    void hueOfAGrayBeginsAtRed() {
        ColorChoice gray = rgb(0.5, 0.5, 0.5);
        assertTrue(Double.isNaN(gray.in(ColorModel.HSV)[0]));
        assertEquals(0x804040, gray.with(ColorModel.HSV, 1, 0.5).rgb());
    }

    @Test
    void colorOutsideTheCubeIsNotTaken() {
        ColorChoice color = rgb(1, 1, 0.9);
        ColorChoice tried = color.with(ColorModel.HVS, 2, 0.8);
        assertTrue(tried.outside());
        assertEquals(color.rgb(), tried.rgb());
        assertEquals(List.of(1.0, 1.0, 0.9), tried.components());
    }

    @Test
    void bytesLoseWhatTheFormulaBringsBack() {
        ColorChoice color = rgb(0.85, 0.45, 0.2);
        color.roundTrips()
                .forEach((model, error) -> assertTrue(error < 1e-12, model + " " + error));
        assertTrue(color.withMethod("eight-bit").roundTrips().get(ColorModel.HVS) > 1e-4);
    }
}
