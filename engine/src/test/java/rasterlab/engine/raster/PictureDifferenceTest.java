package rasterlab.engine.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class PictureDifferenceTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void measuresOnePixel(int expected, int actual, int wrong, int levels) {
        var difference = PictureDifference.of(single(expected), single(actual));
        assertEquals(wrong, difference.wrongPixels());
        assertEquals(15, difference.pixels());
        assertEquals(wrong / 15.0, difference.share());
        assertEquals(levels, difference.largestLevelDifference());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("equal pixels are counted", 0xFF102030, 0xFF102030, 0, 0),
                argumentSet("blue is left out", 0xFF102030, 0xFF102033, 1, 3),
                argumentSet("green is left out", 0xFF102030, 0xFF102930, 1, 9),
                argumentSet("red is left out", 0xFF102030, 0xFF002030, 1, 16),
                argumentSet("alpha is compared with its sign", 0xFF102030, 0x00102030, 1, 255),
                argumentSet("channels are summed", 0xFF102030, 0xFF0E2334, 1, 4));
    }

    @Test
    @DisplayName("the mask marks other pixels than the wrong ones")
    void maskShowsAWrongPixelInADarkEdge() {
        var mask = PictureDifference.of(single(0xFFFFFFFF), single(0xFF000000)).mask();
        var text = new StringBuilder();
        for (int y = 0; y < mask.height(); y++) {
            for (int x = 0; x < mask.width(); x++)
                text.append(
                        mask.argb(x, y) == PictureDifference.WRONG
                                ? '#'
                                : mask.argb(x, y) == PictureDifference.EDGE ? 'x' : '.');
            text.append(' ');
        }
        assertEquals(".xxx. .x#x. .xxx. ", text.toString());
    }

    @Test
    @DisplayName("pictures of different sizes are compared")
    void refusesDifferentSizes() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> PictureDifference.of(new Raster(2, 3), new Raster(3, 2)));
        assertEquals(
                "pictures of one size are compared, got 2×3 expected and 3×2 actual",
                refusal.getMessage());
    }

    /** Black, 5×3, one pixel in the middle. */
    private static Raster single(int argb) {
        var raster = new Raster(5, 3);
        raster.clear(0xFF000000);
        raster.argb()[7] = argb;
        return raster;
    }
}
