package rasterlab.engine.color;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.ColorModel;

class ColorTest {
    /** All 2²⁴ colours with {@code -Drasterlab.full=true}, otherwise every 1,009th. */
    private static final int STRIDE = Boolean.getBoolean("rasterlab.full") ? 1 : 1_009;

    private static final FormulaColors FORMULA = new FormulaColors();

    @ParameterizedTest(name = "a colour of the screen does not come back from {0}")
    @EnumSource(ColorModel.class)
    void everyLevelComesBack(ColorModel model) {
        for (int rgb = 0; rgb < 1 << 24; rgb += STRIDE) {
            double[] there = FORMULA.convert(ColorModel.RGB, Levels.shares(rgb), model);
            double[] back = FORMULA.convert(model, there, ColorModel.RGB);
            int color = rgb;
            assertEquals(
                    0xFF000000 | rgb,
                    Levels.rgb(back[0], back[1], back[2]),
                    () -> "%06x in %s".formatted(color, model.code()));
        }
    }

    @Test
    void mostColorsAreLostInAHueOfEightBits() {
        var bytes = new ByteColors();
        int lost = 0;
        int tried = 0;
        for (int rgb = 0; rgb < 1 << 24; rgb += STRIDE, tried++) {
            double[] there = bytes.convert(ColorModel.RGB, Levels.shares(rgb), ColorModel.HSV);
            double[] back = bytes.convert(ColorModel.HSV, there, ColorModel.RGB);
            if (Levels.rgb(back[0], back[1], back[2]) != (0xFF000000 | rgb)) lost++;
        }
        assertTrue(lost > tried / 2, lost + " of " + tried + " lost");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("worked")
    void converts(ColorModel from, double[] given, ColorModel to, double[] right) {
        assertArrayEquals(right, FORMULA.convert(from, given, to), 4e-16);
    }

    static Stream<Arguments> worked() {
        double[] orange = {1, 0.5, 0};
        return Stream.of(
                argumentSet("cyan is red", ColorModel.RGB, orange, ColorModel.CMY, of(0, 0.5, 1)),
                argumentSet(
                        "black ink is counted twice",
                        ColorModel.RGB,
                        of(0.5, 0.25, 0),
                        ColorModel.CMYK,
                        of(0, 0.5, 1, 0.5)),
                argumentSet(
                        "black has inks",
                        ColorModel.RGB,
                        of(0, 0, 0),
                        ColorModel.CMYK,
                        of(0, 0, 0, 1)),
                argumentSet(
                        "orange is not half way to yellow",
                        ColorModel.RGB,
                        orange,
                        ColorModel.HSV,
                        of(30, 1, 1)),
                argumentSet(
                        "grey has a hue",
                        ColorModel.RGB,
                        of(0.5, 0.5, 0.5),
                        ColorModel.HSV,
                        of(Double.NaN, 0, 0.5)),
                argumentSet(
                        "chapter 7: white is √3 from black",
                        ColorModel.RGB,
                        of(1, 1, 1),
                        ColorModel.HVS,
                        of(Double.NaN, Math.sqrt(3), 0)),
                argumentSet(
                        "chapter 7: red is √(2/3) from the diagonal",
                        ColorModel.RGB,
                        of(1, 0, 0),
                        ColorModel.HVS,
                        of(0, 1 / Math.sqrt(3), Math.sqrt(2 / 3.0))),
                argumentSet(
                        "360° falls into no sector",
                        ColorModel.HSV,
                        of(360, 1, 1),
                        ColorModel.RGB,
                        of(1, 0, 0)),
                argumentSet(
                        "a grey's missing hue is computed with",
                        ColorModel.HSV,
                        of(Double.NaN, 0, 0.25),
                        ColorModel.RGB,
                        of(0.25, 0.25, 0.25)),
                argumentSet(
                        "a hue just below red becomes 360",
                        ColorModel.RGB,
                        of(1, 0, 1e-18),
                        ColorModel.HSV,
                        of(0, 1, 1)));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(ColorModel from, double[] given, String message) {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> FORMULA.convert(from, given, ColorModel.RGB));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a share above 1",
                        ColorModel.RGB,
                        of(0, 1.5, 0),
                        "rgb green must be from 0 to 1, got 1.5"),
                argumentSet(
                        "NaN passes a comparison",
                        ColorModel.CMY,
                        of(0, 0, Double.NaN),
                        "cmy yellow must be from 0 to 1, got NaN"),
                argumentSet(
                        "a hue turns twice",
                        ColorModel.HSV,
                        of(361, 1, 1),
                        "hsv hue must be from 0 to 360, got 361.0"),
                argumentSet(
                        "a colour without hue",
                        ColorModel.HSV,
                        of(Double.NaN, 0.5, 1),
                        "hsv hue must be from 0 to 360, got NaN"),
                argumentSet(
                        "the fourth ink is forgotten",
                        ColorModel.CMYK,
                        of(0, 0, 0),
                        "cmyk has 4 numbers, got 3"),
                argumentSet(
                        "more value than white has",
                        ColorModel.HVS,
                        of(0, 1.8, 0),
                        "hvs value must be from 0 to 1.7321, got 1.8"),
                argumentSet(
                        "a saturation that this value does not have",
                        ColorModel.HVS,
                        of(0, 0, 0.5),
                        "hvs lies outside the colour cube: its green would be -0.20412414523193154,"
                                + " allowed is 0 to 1"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("levels")
    void roundsToTheNearestLevel(double share, int level) {
        assertEquals(level, Levels.of(share));
    }

    static Stream<Arguments> levels() {
        return Stream.of(
                argumentSet("a sum above 1 wraps around", 1.7, 255),
                argumentSet("a negative share wraps around", -0.3, 0),
                argumentSet("NaN is a colour", Double.NaN, 0),
                argumentSet("infinity wraps around", Double.POSITIVE_INFINITY, 255),
                argumentSet("0.5 is cut off instead of rounded", 0.5, 128),
                argumentSet("almost 1 is cut off", 0.999, 255));
    }

    private static double[] of(double... values) {
        return values;
    }
}
