package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Topics {@code spline-function} and {@code curve}. */
class RunSplineTest {
    private static final String HAT = "{\"x\":[0,1,2],\"y\":[0,1,0],\"at\":[0.5,1,3],\"ends\":";
    private static final String ARCH = "{\"kind\":\"bezier\",\"points\":[[0,0],[0,8],[8,8],[8,0]],";

    @Test
    void splineAnswersValuesAndPieces() {
        Ran ran =
                Ran.labReading(HAT + "{\"kind\":\"natural\"}}", "run", "spline-function", "cubic");
        assertEquals(
                "{\"y\":[0.6875,1.0,-1.0],"
                        + "\"coefficients\":[[0.0,1.5,0.0,-0.5],[1.0,0.0,-1.5,0.5]]}\n",
                ran.out());
        ran.assertDone();
    }

    @Test
    void aMethodThatKeepsTheShapeNeedsNoEnds() {
        String knots = "{\"x\":[0,1,3],\"y\":[0,2,3],\"at\":[0.5,2]";
        Ran without = Ran.labReading(knots + "}", "run", "spline-function", "monotone");
        Ran natural =
                Ran.labReading(
                        knots + ",\"ends\":{\"kind\":\"natural\"}}",
                        "run",
                        "spline-function",
                        "monotone");
        without.assertDone();
        assertEquals(natural.out(), without.out());
        Ran.labReading(knots + "}", "run", "spline-function", "cubic")
                .assertComplains(2, "./lab run: /ends: missing; expected a JSON object with kind");
    }

    @Test
    void aPeriodThatClosesWithinRoundingIsClosedAndSaid() {
        String periodic =
                "{\"x\":[0,1,2,3],\"y\":[0,1,-1,%s],\"ends\":{\"kind\":\"periodic\"},\"at\":[3]}";
        String sine = periodic.formatted("-2.4492935982947064e-16");
        for (String method : List.of("cubic", "monotone")) {
            Ran ran = Ran.labReading(sine, "run", "spline-function", method);
            ran.assertDone();
            assertTrue(
                    ran.out()
                            .endsWith(
                                    ",\"note\":\"y[3] = -2.4492935982947064e-16 is taken as y[0] ="
                                            + " 0.0: the period closes within rounding\"}\n"),
                    ran.out());
        }
        Ran exact = Ran.labReading(periodic.formatted("0"), "run", "spline-function", "cubic");
        exact.assertDone();
        assertFalse(exact.out().contains("note"), exact.out());
        Ran open = Ran.labReading(periodic.formatted("1e-14"), "run", "spline-function", "cubic");
        assertEquals(3, open.exitCode(), open.out());
    }

    @Test
    void splineStepsDownAndUpAgain() throws Exception {
        String json = HAT + "{\"kind\":\"slopes\",\"left\":1,\"right\":-1}}";
        Ran ran = Ran.labReading(json, "run", "spline-function", "cubic", "--steps");
        JsonNode steps = new ObjectMapper().readTree(ran.out()).path("steps");
        assertEquals(5, steps.size(), ran.out());
        assertEquals("eliminate", steps.get(1).path("phase").asText());
        assertEquals("substitute", steps.get(2).path("phase").asText());
        assertEquals(2, steps.get(2).path("index").asInt());
    }

    @Test
    void curveAnswersPointsAtGivenT() {
        Ran ran = Ran.labReading(ARCH + "\"at\":[0,0.5,1]}", "run", "curve", "matrix");
        assertEquals("{\"points\":[[0.0,0.0],[4.0,6.0],[8.0,0.0]],\"segments\":2}\n", ran.out());
        ran.assertDone();
    }

    @Test
    void curveStepsAreThePolylineWithItsDecisions() throws Exception {
        Ran ran =
                Ran.labReading(ARCH + "\"flatness\":0.25}", "run", "curve", "adaptive", "--steps");
        JsonNode answer = new ObjectMapper().readTree(ran.out());
        assertEquals(answer.path("segments").asInt() + 1, answer.path("points").size());
        assertEquals(answer.path("points").size(), answer.path("steps").size());
        assertEquals(0, answer.path("steps").get(0).path("t").asDouble());
        assertTrue(answer.path("steps").get(1).path("decision").asDouble() <= 0.25);
    }

    @Test
    void refusalHasTheMethodsMessage() {
        String json = "{\"x\":[0,1,1],\"y\":[0,1,0],\"at\":[],\"ends\":{\"kind\":\"natural\"}}";
        Ran.labReading(json, "run", "spline-function", "cubic")
                .assertComplains(3, "./lab run: cubic refuses: x[2] must be above x[1] = 1, got 1");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesWithPlaceValueAndRange(String topic, String method, String json, String message) {
        Ran.labReading(json, "run", topic, method).assertComplains(2, "./lab run: " + message);
    }

    static Stream<Arguments> mistakes() {
        String spline = "spline-function";
        return Stream.of(
                argumentSet(
                        "unknown kind of ends is natural",
                        spline,
                        "cubic",
                        HAT + "{\"kind\":\"clamped\"}}",
                        "/ends/kind: expected one of natural, not-a-knot, periodic, slopes,"
                                + " got the string \"clamped\""),
                argumentSet(
                        "missing slope is 0",
                        spline,
                        "cubic",
                        HAT + "{\"kind\":\"slopes\",\"left\":1}}",
                        "/ends/right: missing; expected a finite number"),
                argumentSet(
                        "slope of natural ends is ignored",
                        spline,
                        "cubic",
                        HAT + "{\"kind\":\"natural\",\"left\":1}}",
                        "/ends/left: only ends of kind slopes have one, got 1"),
                argumentSet(
                        "value without a knot is ignored",
                        spline,
                        "monotone",
                        "{\"x\":[0],\"y\":[0,1],\"at\":[],\"ends\":{\"kind\":\"natural\"}}",
                        "/y: expected 1 value as /x has, got 2"),
                argumentSet(
                        "neither t nor flatness",
                        "curve",
                        "horner",
                        ARCH.substring(0, ARCH.length() - 1) + "}",
                        "/: expected either at or flatness, got neither"),
                argumentSet(
                        "flatness wins over t",
                        "curve",
                        "horner",
                        ARCH + "\"at\":[0],\"flatness\":1}",
                        "/: expected either at or flatness, got both"),
                argumentSet(
                        "point beyond the range has no place",
                        "curve",
                        "horner",
                        "{\"kind\":\"bezier\",\"points\":[[0,0],[1,1e200]],\"at\":[0]}",
                        "/points/1/1: must be from -1e100 to 1e100, got 1e200"),
                argumentSet(
                        "t beyond the end goes on",
                        "curve",
                        "horner",
                        ARCH + "\"at\":[0,1.5]}",
                        "/at/1: expected a number from 0 to 1, got 1.5"),
                argumentSet(
                        "flatness 0 never ends",
                        "curve",
                        "adaptive",
                        ARCH + "\"flatness\":0}",
                        "/flatness: expected a number of pixels from 1e-100 to 1e100, got 0"),
                argumentSet(
                        "three points make no Hermite curve",
                        "curve",
                        "matrix",
                        "{\"kind\":\"hermite\",\"points\":[[0,0],[1,1],[2,2]],\"at\":[0]}",
                        "/points: must be 4 for hermite, got 3"));
    }
}
