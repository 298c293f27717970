package rasterlab.app.cli.run;

import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Collections;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Inputs within all limits whose product {@code ./lab run} could not work off within seconds. */
class RunWorkTest {
    private static final String WHOLE_RANGE =
            "{\"from\":[-2147483648,0],\"to\":[2147483647,1],\"window\":[0,0,2,2]}";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("tooMuch")
    void isRefusedAtOnce(String topic, String method, String json, String complaint) {
        Ran.labReading(json, "run", topic, method).assertComplains(2, "./lab run: " + complaint);
    }

    static Stream<Arguments> tooMuch() {
        return Stream.of(
                argumentSet(
                        "walks up to the window step by step",
                        "line",
                        "dda-float",
                        WHOLE_RANGE,
                        "/to: at most 500000000 steps by dda-float, got 4294967295"),
                argumentSet(
                        "every turn is of one point",
                        "rotate",
                        "direct",
                        "{\"points\":[" + points(51) + "],\"degrees\":1,\"times\":10000000}",
                        "/times: at most 500000000 points times turns, got 510000000"),
                argumentSet(
                        "every point is compared with one corner",
                        "point-in-polygon",
                        "ray",
                        "{\"polygon\":["
                                + points(16_000)
                                + "],\"points\":["
                                + points(16_000)
                                + "]}",
                        "/points: at most 250000000 corners times points, got 256000000"));
    }

    private static String points(int count) {
        return String.join(",", Collections.nCopies(count, "[1,2]"));
    }

    @Test
    void methodThatBeginsAtTheWindowTakesAnySegment() {
        Ran.labReading(WHOLE_RANGE, "run", "line", "bresenham").assertDone();
    }
}
