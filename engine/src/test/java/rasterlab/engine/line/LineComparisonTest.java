package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;

/** Drawings of the line (0, 0)→(4, 0), given as "x,y x,y …", and how far each is judged to be. */
class LineComparisonTest {
    private static final Segment LINE = new Segment(0, 0, 4, 0);

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("drawings")
    void judges(String drawn, int worst, int missing, int extra, String first) {
        Deviation deviation = compare(drawn);
        assertEquals(new Deviation(worst, missing, extra, 5, first), deviation);
    }

    static Stream<Arguments> drawings() {
        return Stream.of(
                argumentSet("exact", "0,0 1,0 2,0 3,0 4,0", 0, 0, 0, ""),
                argumentSet(
                        "a gap is one pixel wide",
                        "0,0 1,0 3,0 4,0",
                        1,
                        1,
                        0,
                        "pixel (2, 0) is missing"),
                argumentSet(
                        "a wide gap counts its middle",
                        "0,0 4,0",
                        2,
                        3,
                        0,
                        "pixel (1, 0) is missing"),
                argumentSet(
                        "only a pixel far off is extra",
                        "0,0 1,0 2,0 3,0 4,0 2,9",
                        9,
                        0,
                        1,
                        "pixel (2, 9) is extra"),
                argumentSet(
                        "a pixel is beside the line",
                        "0,0 1,0 2,1 3,0 4,0",
                        1,
                        1,
                        1,
                        "pixel (2, 0) is missing, (2, 1) is drawn"),
                argumentSet(
                        "a diagonal neighbour is one away",
                        "0,0 1,0 2,0 3,0 4,0 5,1",
                        1,
                        0,
                        1,
                        "pixel (5, 1) is extra"),
                argumentSet("nothing is drawn", "", 5, 5, 0, "pixel (0, 0) is missing"),
                argumentSet(
                        "a pixel comes twice",
                        "0,0 1,0 1,0 2,0 3,0 4,0",
                        0,
                        0,
                        0,
                        "pixel (1, 0) is drawn again"),
                argumentSet(
                        "a pixel comes twice in a reversed line, and the first one is named",
                        "4,0 3,0 2,0 3,0 1,0 0,0",
                        0,
                        0,
                        0,
                        "pixel (3, 0) is drawn again"),
                argumentSet(
                        "the order is reversed",
                        "4,0 3,0 2,0 1,0 0,0",
                        0,
                        0,
                        0,
                        "pixel (4, 0) comes out of order"));
    }

    @ParameterizedTest(name = "{0} passes for exact")
    @ValueSource(strings = {"0,0 1,0 1,0 2,0 3,0 4,0", "4,0 3,0 2,0 1,0 0,0"})
    void whatIsRepeatedOrReversedIsDegraded(String drawn) {
        LineTopic topic = new LineTopic();
        assertFalse(compare(drawn).exact());
        assertTrue(topic.usable(compare(drawn)));
    }

    @Test
    void tenThousandPixelsFarFromALongLineAreJudgedAtOnce() {
        var exact = new ExactLine(new Segment(0, 0, 9_999, 7_000)).record(10_000);
        var flat = new ExactLine(new Segment(0, 0, 9_999, 0)).record(10_000);
        Deviation deviation = new LineTopic().compare(LINE, exact, flat);
        assertEquals(7_000, deviation.worst());
        assertEquals(10_000, deviation.of());
    }

    private static Deviation compare(String drawn) {
        var actual = new PixelRecording(100);
        for (String pixel : drawn.split(" ")) {
            if (pixel.isEmpty()) continue;
            String[] xy = pixel.split(",");
            actual.plot(Integer.parseInt(xy[0]), Integer.parseInt(xy[1]));
        }
        return LineComparison.compare(new ExactLine(LINE).record(100), actual);
    }
}
