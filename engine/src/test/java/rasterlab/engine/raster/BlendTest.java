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
    void laysOneColorOverAnother(int above, int below, int expected) {
        int actual = Blend.over(above, below);
        for (int shift = 0; shift < 32; shift += 8)
            assertEquals(
                    expected >>> shift & 0xFF,
                    actual >>> shift & 0xFF,
                    1,
                    () -> Integer.toHexString(actual));
    }

    static Stream<Arguments> cases() {
        return Stream.of(
                argumentSet("an opaque colour leaves a rest", 0xFF123456, 0xFFABCDEF, 0xFF123456),
                argumentSet("nothing leaves a trace", 0x00123456, 0xFFABCDEF, 0xFFABCDEF),
                argumentSet("half a colour on nothing loses it", 0x804080C0, 0, 0x804080C0),
                argumentSet("nothing on nothing divides by 0", 0, 0, 0),
                argumentSet(
                        "a half transparent colour covers wholly",
                        0x80FFFFFF,
                        0xFF000000,
                        0xFF808080),
                argumentSet("the lower alpha is forgotten", 0x80FF0000, 0x800000FF, 0xC0AA0055));
    }
}
