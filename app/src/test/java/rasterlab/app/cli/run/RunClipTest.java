package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;

class RunClipTest {
    private static final String WINDOW = "{\"window\":[0,0,10,10],";
    private static final String SEGMENTS =
            WINDOW + "\"segments\":[[5,2,15,8],[-5,2,-1,8],[-3,3,3,-3],[1,2,3,4]]}";

    @ParameterizedTest
    @ValueSource(
            strings = {"four-lines", "cohen-sutherland", "liang-barsky", "midpoint", "cyrus-beck"})
    void segmentsKeepTheirOrderAndNothingLeftIsNull(String method) {
        Ran ran = Ran.labReading(SEGMENTS, "run", "clip-segment", method);
        assertEquals(
                "{\"segments\":[[5.0,2.0,10.0,5.0],null,[0.0,0.0,0.0,0.0],[1.0,2.0,3.0,4.0]]}\n",
                ran.out());
        ran.assertDone();
    }

    @Test
    void theTextbooksVersionDrawsWhatLiesOutside() {
        String outside = WINDOW + "\"segments\":[[-5,2,-1,8]]}";
        Ran ran = Ran.labReading(outside, "run", "clip-segment", "cohen-sutherland-textbook");
        assertEquals("{\"segments\":[[-5.0,2.0,-1.0,8.0]]}\n", ran.out());
    }

    @Test
    void anEndlessMethodIsGivenUp() {
        Ran.labReading(
                        WINDOW + "\"segments\":[[-5,5,5,5]]}",
                        "run",
                        "clip-segment",
                        "cohen-sutherland-nested-textbook")
                .assertComplains(
                        4,
                        "./lab run: cohen-sutherland-nested-textbook does not end:"
                                + " it made more than 1000 steps for one segment");
    }

    @Test
    void stepsAreAListForEachSegment() throws Exception {
        Ran ran = Ran.labReading(SEGMENTS, "run", "clip-segment", "liang-barsky", "--steps");
        JsonNode answer = new ObjectMapper().readTree(ran.out());
        assertEquals(4, answer.path("steps").size());
        JsonNode first = answer.path("steps").get(0);
        assertEquals(4, first.size());
        assertEquals("right", first.get(1).path("at").asText());
        assertEquals(0.5, first.get(1).path("decision").asDouble());
        assertTrue(answer.path("decision").asText().startsWith("t = "), ran.out());
        JsonNode touching = answer.path("steps").get(2);
        assertEquals("without rounding", touching.get(touching.size() - 1).path("at").asText());
    }

    @Test
    void noSegmentsLeaveNone() {
        Ran ran =
                Ran.labReading(WINDOW + "\"segments\":[]}", "run", "clip-segment", "liang-barsky");
        assertEquals("{\"segments\":[]}\n", ran.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"cohen-sutherland-6", "homogeneous"})
    void theVolumeKeepsWhatIsInFrontOfTheEye(String method) {
        String in =
                "{\"zmin\":0.25,\"segments\":[[0,0,-1,0,0,1],[0.1,0.1,-0.5,0,0,-0.9],"
                        + "[0,0,0.5,2,0,0.5]]}";
        Ran ran = Ran.labReading(in, "run", "clip-volume", method);
        assertEquals(
                "{\"segments\":[[0.0,0.0,0.25,0.0,0.0,1.0],null,[0.0,0.0,0.5,0.5,0.0,0.5]]}\n",
                ran.out());
        Ran steps = Ran.labReading(in, "run", "clip-volume", method, "--steps");
        assertTrue(steps.out().contains("\"steps\":[[{\"at\":\""), steps.out());
    }

    @Test
    void onlyWeilerAthertonSeparatesThePieces() {
        String bars = WINDOW + "\"polygon\":[[2,2],[14,2],[14,8],[2,8],[2,7],[13,7],[13,3],[2,3]]}";
        Ran apart = Ran.labReading(bars, "run", "clip-polygon", "weiler-atherton");
        assertEquals(
                "{\"polygons\":[[[10.0,8.0],[2.0,8.0],[2.0,7.0],[10.0,7.0]],"
                        + "[[10.0,3.0],[2.0,3.0],[2.0,2.0],[10.0,2.0]]]}\n",
                apart.out());
        Ran bridged = Ran.labReading(bars, "run", "clip-polygon", "sutherland-hodgman", "--steps");
        assertTrue(
                bridged.out().startsWith("{\"polygons\":[[[2.0,2.0],[10.0,2.0],"), bridged.out());
        assertTrue(bridged.out().contains("\"steps\":[{\"at\":\"side 0\","), bridged.out());
    }

    @Test
    void theWindowMayBeAConvexPolygon() {
        Ran ran =
                Ran.labReading(
                        "{\"window\":[[0,0],[4,0],[0,4]],\"polygon\":[[1,1],[9,1],[9,9],[1,9]]}",
                        "run",
                        "clip-polygon",
                        "sutherland-hodgman");
        assertEquals("{\"polygons\":[[[1.0,3.0],[1.0,1.0],[3.0,1.0]]]}\n", ran.out());
    }

    @Test
    void onlyCyrusAndBeckClipSegmentsByAConvexPolygon() {
        String in = "{\"window\":[[0,4],[4,0],[0,0]],\"segments\":[[1,1,5,1],[4,4,5,4]]}";
        Ran ran = Ran.labReading(in, "run", "clip-segment", "cyrus-beck");
        assertEquals("{\"segments\":[[1.0,1.0,3.0,1.0],null]}\n", ran.out());
        Ran.labReading(in, "run", "clip-segment", "liang-barsky")
                .assertComplains(
                        3,
                        "./lab run: liang-barsky refuses: window must be [xmin,ymin,xmax,ymax]; the"
                                + " corners of a convex polygon are taken by cyrus-beck");
    }

    @Test
    void aWindowThatIsNotConvexIsRefusedEvenWithoutSegments() {
        Ran.labReading(
                        "{\"window\":[[0,0],[4,0],[1,1],[0,4]],\"segments\":[]}",
                        "run",
                        "clip-segment",
                        "cyrus-beck")
                .assertComplains(
                        3,
                        "./lab run: cyrus-beck refuses: window must be convex, but turns the other"
                                + " way at its corner (1, 1)");
    }

    @Test
    void aSubjectThatCrossesItselfIsRefused() {
        Ran.labReading(
                        WINDOW + "\"polygon\":[[1,1],[9,9],[9,1],[1,9]]}",
                        "run",
                        "clip-polygon",
                        "weiler-atherton")
                .assertComplains(
                        3,
                        "./lab run: weiler-atherton refuses: polygon must be simple, but the edges"
                                + " from corners (1, 1) and (9, 1) meet");
    }

    static Stream<Arguments> wrong() {
        return Stream.of(
                argumentSet(
                        "sides are swapped",
                        "clip-segment",
                        "liang-barsky",
                        "{\"window\":[3,0,2,1],\"segments\":[]}",
                        "/window: xmin must be at most xmax, got 3 > 2"),
                argumentSet(
                        "a segment has three numbers",
                        "clip-segment",
                        "liang-barsky",
                        WINDOW + "\"segments\":[[1,2,3]]}",
                        "/segments/0: only 3 values; expected an array of 4 numbers"),
                argumentSet(
                        "a coordinate is no finite number",
                        "clip-segment",
                        "liang-barsky",
                        WINDOW + "\"segments\":[[1,2,3,1e999]]}",
                        "/segments/0/3: expected a number from"),
                argumentSet(
                        "segments are missing",
                        "clip-segment",
                        "midpoint",
                        "{\"window\":[0,0,1,1]}",
                        "/segments: missing"),
                argumentSet(
                        "the nearest plane is at the eye",
                        "clip-volume",
                        "homogeneous",
                        "{\"zmin\":0,\"segments\":[]}",
                        "/zmin: must be a number above 0 and below 1, got 0"),
                argumentSet(
                        "the window has five numbers",
                        "clip-polygon",
                        "weiler-atherton",
                        "{\"window\":[0,0,1,1,2],\"polygon\":[]}",
                        "/window: expected [xmin,ymin,xmax,ymax] or an array of points"),
                argumentSet(
                        "the window mixes numbers and points",
                        "clip-polygon",
                        "weiler-atherton",
                        "{\"window\":[0,0,1,[1,2]],\"polygon\":[]}",
                        "/window: expected [xmin,ymin,xmax,ymax] or an array of points"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("wrong")
    void wrongInputIsNamedByPlace(String topic, String method, String in, String message) {
        Ran ran = Ran.labReading(in, "run", topic, method);
        assertTrue(ran.err().startsWith("./lab run: " + message), ran.err());
        assertEquals(1, ran.err().lines().count());
        assertEquals("", ran.out());
        assertEquals(2, ran.exitCode());
    }
}
