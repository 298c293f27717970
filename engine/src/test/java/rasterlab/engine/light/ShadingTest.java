package rasterlab.engine.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ShadingTest {
    private static final FaceSide FACING = side(0, 0, -1, false);
    private static final FaceSide SLANTED = side(0.6, 0, -0.8, false);

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void hasIntensity(Shading shading, FaceSide side, double intensity) {
        assertEquals(intensity, shading.intensity(side), 1e-15);
    }

    static Stream<Arguments> mistakes() {
        var tone = new ToneShading();
        var atEye = FlatShading.lightAtEye(0.2);
        var oblique = new FaceSide(0.6, 0, -0.8, 0.6, 0, -0.8, false);
        return Stream.of(
                argumentSet("tone keeps the sign of n_z", tone, SLANTED, 0.8),
                argumentSet(
                        "tone does not darken the inside", tone, side(0.6, 0, -0.8, true), 0.48),
                argumentSet("tone looks at the way to the eye", tone, oblique, 0.8),
                argumentSet("ambient is added on top", atEye, FACING, 1),
                argumentSet("diffuse is not scaled by 1 − a", atEye, SLANTED, 0.2 + 0.8 * 0.8),
                argumentSet("light at the eye shines along z", atEye, oblique, 1),
                argumentSet(
                        "light from behind darkens below ambient",
                        FlatShading.lightFrom(0.3, 0, 0, 1),
                        FACING,
                        0.3),
                argumentSet(
                        "direction to the light is not made a unit",
                        FlatShading.lightFrom(0, 10, 0, 0),
                        SLANTED,
                        0.6));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("levels")
    void shades(int rgb, double intensity, int argb) {
        assertEquals(Integer.toHexString(argb), Integer.toHexString(Shading.shade(rgb, intensity)));
    }

    static Stream<Arguments> levels() {
        return Stream.of(
                argumentSet("channels are swapped", 0x804020, 1, 0xFF804020),
                argumentSet("levels are cut, not rounded", 0x000003, 0.9, 0xFF000003),
                argumentSet("above 1 runs into the next channel", 0x00FF00, 1.5, 0xFF00FF00),
                argumentSet("below 0 wraps to white", 0xFFFFFF, -0.1, 0xFF000000),
                argumentSet("a tie always goes up", 0x050307, 0.5, 0xFF020204));
    }

    @Test
    @DisplayName("bad numbers give a black picture")
    void refusesWithTheValue() {
        assertMessage("ambient must be from 0 to 1, got 1.5", () -> FlatShading.lightAtEye(1.5));
        assertMessage(
                "direction to the light must be finite and not zero, got (0.0, 0.0, 0.0)",
                () -> FlatShading.lightFrom(0.2, 0, 0, 0));
        assertMessage(
                "normal (0.0, 0.0, -2.0) must have length 1, got 2.0", () -> side(0, 0, -2, false));
        assertMessage(
                "no shading 'phong'; there are tone, flat", () -> new Shadings().named("phong"));
    }

    private static void assertMessage(String message, Runnable call) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, call::run).getMessage());
    }

    private static FaceSide side(double nx, double ny, double nz, boolean inner) {
        return new FaceSide(nx, ny, nz, 0, 0, -1, inner);
    }
}
