package rasterlab.engine.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ToneShadingTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void hasIntensity(double nz, boolean inner, double intensity) {
        assertEquals(intensity, ToneShading.intensity(nz, inner), 1e-15);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("tone keeps the sign of n_z", -0.8, false, 0.8),
                argumentSet("tone does not darken the inside", -0.8, true, 0.48));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("levels")
    void shades(int rgb, double intensity, int argb) {
        assertEquals(
                Integer.toHexString(argb), Integer.toHexString(ToneShading.shade(rgb, intensity)));
    }

    static Stream<Arguments> levels() {
        return Stream.of(
                argumentSet("channels are swapped", 0x804020, 1, 0xFF804020),
                argumentSet("levels are cut, not rounded", 0x000003, 0.9, 0xFF000003),
                argumentSet("above 1 runs into the next channel", 0x00FF00, 1.5, 0xFF00FF00),
                argumentSet("below 0 wraps to white", 0xFFFFFF, -0.1, 0xFF000000),
                argumentSet("a tie always goes up", 0x050307, 0.5, 0xFF020204));
    }
}
