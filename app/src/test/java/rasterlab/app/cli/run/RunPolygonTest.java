package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;

/** Topics point-in-triangle, point-in-polygon and triangulate by {@code ./lab run}. */
class RunPolygonTest {
    private static final String TRIANGLE = "{\"triangle\":[[0,0],[8,0],[0,8]],\"points\":";
    private static final String SQUARE = "[[0,0],[4,0],[4,4],[0,4]]";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("answers")
    void answers(String topic, String method, String json, String answer) {
        Ran ran = Ran.labReading(json, "run", topic, method);
        assertEquals(answer + "\n", ran.out());
        ran.assertDone();
    }

    static Stream<Arguments> answers() {
        return Stream.of(
                argumentSet(
                        "boundary of a triangle is outside",
                        "point-in-triangle",
                        "robust",
                        TRIANGLE + "[[1,1],[4,4],[5,4],[0,8]]}",
                        "{\"inside\":[true,true,false,true]}"),
                argumentSet(
                        "fractions are cut off",
                        "point-in-triangle",
                        "half-plane",
                        TRIANGLE + "[[3.5,4.75],[3.25,4.5]]}",
                        "{\"inside\":[false,true]}"),
                argumentSet(
                        "no points is an error",
                        "point-in-triangle",
                        "robust",
                        TRIANGLE + "[]}",
                        "{\"inside\":[]}"),
                argumentSet(
                        "boundary of a polygon is outside",
                        "point-in-polygon",
                        "robust",
                        "{\"polygon\":" + SQUARE + ",\"points\":[[4,2],[2,2],[5,5]]}",
                        "{\"inside\":[true,true,false]}"),
                argumentSet(
                        "triples go the way the corners do",
                        "triangulate",
                        "fan",
                        "{\"polygon\":[[0,4],[4,4],[4,0],[0,0]]}",
                        "{\"triangles\":[[2,1,0],[3,2,0]]}"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(int code, String topic, String method, String json, String message) {
        Ran.labReading(json, "run", topic, method).assertComplains(code, "./lab run: " + message);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "two corners are a triangle",
                        2,
                        "point-in-triangle",
                        "robust",
                        "{\"triangle\":[[0,0],[8,0]],\"points\":[[1,1]]}",
                        "/triangle: only 2 values; expected an array of 3 points of 2 numbers"
                                + " each"),
                argumentSet(
                        "point has a z",
                        2,
                        "point-in-triangle",
                        "robust",
                        TRIANGLE + "[[1,1,1]]}",
                        "/points/0: more than 2 values; expected an array of 2 numbers"),
                argumentSet(
                        "points are missing",
                        2,
                        "point-in-polygon",
                        "robust",
                        "{\"polygon\":" + SQUARE + "}",
                        "/points: missing; expected an array of 0 to 10000000 points of 2 numbers"
                                + " each"),
                argumentSet(
                        "one point is a polygon",
                        2,
                        "triangulate",
                        "ear-clipping",
                        "{\"polygon\":[[1,1]]}",
                        "/polygon: only 1 value; expected an array of 3 to 10000000 points of 2"
                                + " numbers each"),
                argumentSet(
                        "fraction reaches int arithmetic",
                        3,
                        "point-in-triangle",
                        "sign-int",
                        TRIANGLE + "[[0.5,1]]}",
                        "sign-int refuses: coordinates must be whole numbers from -2147483648 to"
                                + " 2147483647, got 0.5"),
                argumentSet(
                        "crossing edges are cut",
                        3,
                        "triangulate",
                        "ear-clipping",
                        "{\"polygon\":[[0,0],[4,4],[0,4],[4,0]]}",
                        "ear-clipping refuses: edges may meet only at the corner they share, but"
                                + " those from corners 0 and 2 meet elsewhere"),
                argumentSet(
                        "fan leaves the polygon",
                        3,
                        "triangulate",
                        "fan",
                        "{\"polygon\":[[0,0],[9,4],[0,8],[3,4]]}",
                        "fan refuses: a fan needs a convex polygon without corners on the sides at"
                                + " corner 0, but corner 3 (3, 4) is in the way"));
    }

    @Test
    void stepsOfARayAreItsEdgesWithTheCountSoFar() {
        String json = "{\"polygon\":" + SQUARE + ",\"points\":[[2,2]]}";
        Ran ran = Ran.labReading(json, "run", "point-in-polygon", "ray", "--steps");
        assertTrue(
                ran.out()
                        .contains(
                                "\"steps\":[[{\"edge\":0,\"count\":0,\"decision\":0},"
                                        + "{\"edge\":1,\"count\":1,\"decision\":1},"
                                        + "{\"edge\":2,\"count\":1,\"decision\":1},"
                                        + "{\"edge\":3,\"count\":1,\"decision\":1}]]"),
                ran.out());
        assertTrue(ran.out().contains("\"decision\":\"edges with "), ran.out());
        ran.assertDone();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("cuts")
    void stepsOfATriangulationAreItsCutsInOrder(String method, String polygon, String steps)
            throws Exception {
        String json = "{\"polygon\":" + polygon + "}";
        Ran ran = Ran.labReading(json, "run", "triangulate", method, "--steps");
        var told = new ArrayList<String>();
        for (JsonNode step : new ObjectMapper().readTree(ran.out()).path("steps"))
            told.add(step.path("cut") + " by " + step.path("diagonal"));
        assertEquals(steps, String.join(", ", told));
        ran.assertDone();
    }

    static Stream<Arguments> cuts() {
        return Stream.of(
                argumentSet(
                        "cut corner is an end of the diagonal",
                        "shortest-diagonal",
                        "[[0,0],[8,0],[8,3],[4,3],[4,6],[0,6]]",
                        "2 by [1,3], 1 by [0,3], 0 by [5,3], 5 by [4,3]"),
                argumentSet(
                        "clockwise cuts are told counter-clockwise",
                        "ear-clipping",
                        "[[0,6],[4,6],[4,3],[8,3],[8,0],[0,0]]",
                        "4 by [5,3], 3 by [5,2], 2 by [5,1], 1 by [5,0]"),
                argumentSet(
                        "fan cuts off a corner of the diagonal",
                        "fan",
                        "[[0,0],[4,0],[4,4],[0,4]]",
                        "1 by [0,2], 2 by [0,3]"),
                argumentSet(
                        "clockwise fan cuts off a corner of the diagonal",
                        "fan",
                        "[[0,4],[4,4],[4,0],[0,0]]",
                        "1 by [2,0], 2 by [3,0]"));
    }

    @Test
    void methodWithoutStepsSaysSo() {
        String call = "{\"name\":\"ROT3DX\",\"angle\":9}";
        Ran.labReading(call, "run", "matrix", "formula", "--steps")
                .assertComplains(2, "./lab run: --steps: method 'formula' has no steps");
    }

    @ParameterizedTest
    @ValueSource(strings = {"shortest-diagonal-textbook", "shortest-diagonal"})
    void aHundredThousandCornersAreRefusedByTheirNumber(String method) {
        var random = new Random(1);
        String corners =
                random.doubles(100_000)
                        .mapToObj(v -> "[" + v + "," + 2 * v + "]")
                        .collect(Collectors.joining(","));
        Ran.labReading("{\"polygon\":[" + corners + "]}", "run", "triangulate", method)
                .assertComplains(
                        3,
                        "./lab run: "
                                + method
                                + " refuses: at most 20000 corners are taken, got 100000");
    }
}
