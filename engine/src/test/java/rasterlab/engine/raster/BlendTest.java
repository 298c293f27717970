package rasterlab.engine.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class BlendTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("cases")
    void laysOneColourOverAnother(int above, int below, int coverage, int expected) {
        int actual = Blend.over(above, below, coverage);
        for (int shift = 0; shift < 32; shift += 8)
            assertEquals(
                    expected >>> shift & 0xFF,
                    actual >>> shift & 0xFF,
                    1,
                    () -> Integer.toHexString(actual));
    }

    static Stream<Arguments> cases() {
        return Stream.of(
                argumentSet("whole cover leaves a rest", 0xFF123456, 0xFFABCDEF, 256, 0xFF123456),
                argumentSet("no cover leaves a trace", 0xFF123456, 0xFFABCDEF, 0, 0xFFABCDEF),
                argumentSet(
                        "channels run into each other", 0xFFFF00FF, 0xFF00FF00, 128, 0xFF7F7F7F),
                argumentSet("half a colour on nothing loses it", 0xFF4080C0, 0, 128, 0x804080C0),
                argumentSet("nothing on nothing divides by 0", 0, 0, 128, 0),
                argumentSet(
                        "a half transparent colour covers wholly",
                        0x80FFFFFF,
                        0xFF000000,
                        256,
                        0xFF808080),
                argumentSet(
                        "the lower alpha is forgotten", 0x80FF0000, 0x800000FF, 256, 0xC0AA0055));
    }
}
