package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/** Checks what {@code --steps} adds, for every method that has steps. */
class RunStepsTest {
    /** The topics whose steps are formulas or matrices one after the other; nothing is decided. */
    private static final List<String> UNDECIDED =
            List.of("transform", "rotate-axis", "rotate", "view", "shade", "shade-face");

    /** Draws textbooks' programs as they are printed, and reads how that is told. */
    private static final Map<String, String> GIVEN_UP =
            Map.of(
                    "triangulate shortest-diagonal-printed-textbook", " crashed: ",
                    "clip-segment cohen-sutherland-nested-textbook", " does not end: ");

    static Stream<String> topics() {
        return Topics.all().stream().map(Topic::name);
    }

    @ParameterizedTest(name = "a step of {0} has no decision value, or the value no formula")
    @MethodSource("topics")
    void everyStepHasItsDecision(String topic) throws Exception {
        for (var method : Topics.named(topic).methods()) {
            String name = topic + " " + method.name();
            Ran ran = stepped(topic, method.name());
            if (ran.err().contains("has no steps")) continue;
            if (GIVEN_UP.containsKey(name)) assertGivenUp(ran, method.name(), GIVEN_UP.get(name));
            else assertSteps(ran, UNDECIDED.contains(topic), method.name());
        }
    }

    private static void assertGivenUp(Ran ran, String method, String verdict) {
        assertEquals(4, ran.exitCode());
        assertTrue(ran.err().startsWith("./lab run: " + method + verdict), ran.err());
        assertEquals("", ran.out());
    }

    private static void assertSteps(Ran ran, boolean undecided, String method) throws Exception {
        ran.assertDone();
        JsonNode answer = new ObjectMapper().readTree(ran.out());
        assertEquals(undecided, answer.path("decision").asText().isEmpty(), ran.out());
        assertFalse(answer.path("steps").isEmpty(), ran.out());
        for (JsonNode step : answer.path("steps"))
            for (JsonNode one : step.isArray() ? step : List.of(step))
                if (undecided) assertTrue(one.has("step") || one.has("matrices"), method);
                else assertTrue(one.has("decision"), method + ": " + one);
    }

    @Test
    void methodIsGivenUpWithoutStepsToo() {
        GIVEN_UP.forEach(
                (name, verdict) -> {
                    String[] names = name.split(" ");
                    Ran ran =
                            Ran.labReading(GoldenFile.example(names[0]), "run", names[0], names[1]);
                    assertGivenUp(ran, names[1], verdict);
                });
    }

    private static Ran stepped(String topic, String method) {
        return Ran.labReading(GoldenFile.example(topic), "run", topic, method, "--steps");
    }

    @ParameterizedTest(name = "--steps changes the answer of {0}")
    @MethodSource("topics")
    void theAnswerIsTheSameWithItsSteps(String topic) throws Exception {
        for (var method : Topics.named(topic).methods()) {
            Ran ran = stepped(topic, method.name());
            if (ran.exitCode() != 0) continue;
            JsonNode plain =
                    new ObjectMapper()
                            .readTree(
                                    Ran.labReading(
                                                    GoldenFile.example(topic),
                                                    "run",
                                                    topic,
                                                    method.name())
                                            .out());
            JsonNode answer = new ObjectMapper().readTree(ran.out());
            plain.fieldNames()
                    .forEachRemaining(
                            name -> assertEquals(plain.get(name), answer.get(name), method.name()));
        }
    }

    @Test
    void cutIsDecidedByItsDiagonalAndAClippedPolygonByItsCorners() {
        assertTrue(
                stepped("triangulate", "shortest-diagonal")
                        .out()
                        .contains("{\"cut\":0,\"diagonal\":[3,1],\"decision\":25.0}"));
        assertTrue(
                stepped("clip-polygon", "sutherland-hodgman")
                        .out()
                        .contains("{\"at\":\"side 1\",\"decision\":4,\"polygon\":["));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("walks")
    void stepsAreThoseOfTheWalk(String topic, String method, String json, String steps) {
        Ran ran = Ran.labReading(json, "run", topic, method, "--steps");
        ran.assertDone();
        assertTrue(ran.out().endsWith(steps + "}\n"), ran.out());
    }

    static Stream<Arguments> walks() {
        return Stream.of(
                argumentSet(
                        "sides are asked after one told the point to be outside",
                        "point-in-triangle",
                        "sign-double",
                        "{\"triangle\":[[0,0],[8,0],[0,8]],\"points\":[[1,1],[9,9]]}",
                        "\"steps\":[[{\"side\":0,\"decision\":-8.0},{\"side\":1,\"decision\":-48.0},"
                                + "{\"side\":2,\"decision\":-8.0}],"
                                + "[{\"side\":0,\"decision\":-72.0},{\"side\":1,\"decision\":80.0}]]"),
                argumentSet(
                        "de Casteljau's triangle is not told row by row",
                        "curve",
                        "de-casteljau",
                        "{\"kind\":\"bezier\",\"points\":[[0,0],[0,8],[8,8],[8,0]],\"at\":[1,0.5]}",
                        ",{\"step\":\"(1 − u)·P[i] + u·P[i + 1]\",\"factor\":0.5,"
                                + "\"points\":[[2.0,6.0],[6.0,6.0]]},"
                                + "{\"step\":\"(1 − u)·P[i] + u·P[i + 1]\",\"factor\":0.5,"
                                + "\"points\":[[4.0,6.0]]}]]"),
                argumentSet(
                        "turns are told without the point",
                        "rotate",
                        "direct",
                        "{\"points\":[[1,2]],\"degrees\":90,\"times\":1}",
                        "\"steps\":[[{\"turn\":1,\"step\":\"x' = x·cos θ − y·sin θ\",\"value\":-2.0,"
                                + "\"point\":[1.0,2.0]},"
                                + "{\"turn\":1,\"step\":\"y' = x·sin θ + y·cos θ\",\"value\":1.0,"
                                + "\"point\":[-2.0,1.0]}]]"),
                argumentSet(
                        "no turn loses the point",
                        "rotate",
                        "buneman",
                        "{\"points\":[[1,2]],\"degrees\":90,\"times\":0}",
                        "{\"points\":[[1.0,2.0]],\"steps\":[[]]"),
                argumentSet(
                        "drift is told of the first row only",
                        "depth-buffer",
                        "incremental-z16",
                        "{\"near\":1,\"far\":2,\"depths\":[1,2],\"to\":[2,2],\"pixels\":3}",
                        "\"steps\":[[{\"pixel\":0,\"sum\":0.0,\"code\":0,\"decision\":0.0},"
                                + "{\"pixel\":1,\"sum\":32767.5,\"code\":32768,\"decision\":0.0},"
                                + "{\"pixel\":2,\"sum\":65535.0,\"code\":65535,\"decision\":0.0}],"
                                + "[{\"pixel\":0,\"sum\":65535.0,\"code\":65535,\"decision\":0.0},"
                                + "{\"pixel\":1,\"sum\":65535.0,\"code\":65535,\"decision\":0.0},"
                                + "{\"pixel\":2,\"sum\":65535.0,\"code\":65535,\"decision\":0.0}]]"),
                argumentSet(
                        "recursive fill has no steps",
                        "fill",
                        "recursive-textbook",
                        "{\"picture\":[\"..#\",\"...\"],\"seed\":[0,0],\"with\":\"*\",\"connectivity\":4}",
                        "\"decision\":\"how many calls wait for this one to end\",\"steps\":["
                                + "{\"y\":0,\"from\":0,\"to\":2,\"decision\":0},"
                                + "{\"y\":1,\"from\":0,\"to\":3,\"decision\":1}]"),
                argumentSet(
                        "circle by its angle has no steps",
                        "circle",
                        "parametric",
                        "{\"center\":[0,0],\"radius\":1}",
                        "\"steps\":[{\"u\":0,\"v\":1,\"decision\":0.0},"
                                + "{\"u\":1,\"v\":1,\"decision\":1.0}]"),
                argumentSet(
                        "a term is added twice, or the cut is not told",
                        "shade",
                        "lambert",
                        "{\"normal\":[0,0,1],\"to-light\":[0,0,1],\"to-eye\":[0,0,1],"
                                + "\"material\":{\"emission\":[0.5,0,0],\"diffuse\":[1,1,0]},"
                                + "\"light\":{\"diffuse\":[0.75,0.5,0]}}",
                        "{\"step\":\"diffuse\",\"value\":[0.75,0.5,0.0],\"sum\":[1.25,0.5,0.0]},"
                                + "{\"step\":\"specular\",\"value\":[0.0,0.0,0.0],"
                                + "\"sum\":[1.25,0.5,0.0]},"
                                + "{\"step\":\"cut to [0, 1]\",\"value\":[1.0,0.5,0.0],"
                                + "\"sum\":[1.0,0.5,0.0]}]"),
                argumentSet(
                        "face without area is added, or the sum is that of another vertex",
                        "vertex-normals",
                        "area",
                        "{\"vertices\":[[0,0,0],[2,0,0],[0,2,0],[0,1,0],[0,0,1]],"
                                + "\"triangles\":[[0,3,2],[0,1,2],[0,2,4]]}",
                        "\"decision\":\"area of the face over the largest\",\"steps\":["
                                + "{\"face\":1,\"vertex\":0,\"decision\":1.0,\"sum\":[0.0,0.0,1.0]},"
                                + "{\"face\":1,\"vertex\":1,\"decision\":1.0,\"sum\":[0.0,0.0,1.0]},"
                                + "{\"face\":1,\"vertex\":2,\"decision\":1.0,\"sum\":[0.0,0.0,1.0]},"
                                + "{\"face\":2,\"vertex\":0,\"decision\":0.5,\"sum\":[0.5,0.0,1.0]},"
                                + "{\"face\":2,\"vertex\":2,\"decision\":0.5,\"sum\":[0.5,0.0,1.0]},"
                                + "{\"face\":2,\"vertex\":4,\"decision\":0.5,\"sum\":[0.5,0.0,0.0]}]"),
                argumentSet(
                        "texels and their shares are not told",
                        "texture-filter",
                        "linear",
                        "{\"picture\":[[10,20],[30,40]],\"pixels\":[[0.375,0.5,0.25,0,0,0.25]]}",
                        "\"steps\":[[{\"detail\":0,\"column\":0,\"row-from-below\":0,\"level\":30,"
                                + "\"decision\":0.375},{\"detail\":0,\"column\":1,"
                                + "\"row-from-below\":0,\"level\":40,\"decision\":0.125},"
                                + "{\"detail\":0,\"column\":0,\"row-from-below\":1,\"level\":10,"
                                + "\"decision\":0.375},{\"detail\":0,\"column\":1,"
                                + "\"row-from-below\":1,\"level\":20,\"decision\":0.125}]]"),
                argumentSet(
                        "convex window has no steps",
                        "clip-segment",
                        "cyrus-beck",
                        "{\"window\":[[0,0],[4,0],[0,4]],\"segments\":[[1,1,5,1]]}",
                        ",{\"at\":\"edge from (4.0, 0.0)\",\"decision\":0.5,"
                                + "\"segment\":[1.0,1.0,3.0,1.0]},"
                                + "{\"at\":\"edge from (0.0, 4.0)\",\"decision\":null,"
                                + "\"segment\":[1.0,1.0,3.0,1.0]}]]"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("tooManySteps")
    void stepsBeyondMemoryAreRefused(String topic, String method, String json, String message) {
        Ran.labReading(json, "run", topic, method, "--steps")
                .assertComplains(2, "./lab run: --steps: " + message);
    }

    static Stream<Arguments> tooManySteps() {
        return Stream.of(
                argumentSet(
                        "turns of all points",
                        "rotate",
                        "direct",
                        "{\"points\":[[1,2],[3,4]],\"degrees\":9,\"times\":10000000}",
                        "at most 100000 points times turns, got 20000000"),
                argumentSet(
                        "curve points of the highest degree",
                        "curve",
                        "de-casteljau",
                        "{\"kind\":\"bezier\",\"points\":["
                                + repeated(101, "[1,2]")
                                + "],\"at\":["
                                + repeated(195, "0.5")
                                + "]}",
                        "at most 1000000 points on the way to all t, got 1004445"),
                argumentSet(
                        "points seen from the eye",
                        "view",
                        "taken-apart",
                        "{\"points\":["
                                + repeated(100_001, "[1,2,3]")
                                + "],\"theta\":1,\"phi\":2,\"rho\":3}",
                        "at most 100000 points, got 100001"),
                argumentSet(
                        "points after each of many matrices",
                        "transform",
                        "double",
                        "{\"matrices\":["
                                + repeated(101, "{\"name\":\"IDENTITY\"}")
                                + "],\"points\":["
                                + repeated(9901, "[1,2,3]")
                                + "]}",
                        "at most 1000000 points times matrices, got 1000001"),
                argumentSet(
                        "points judged",
                        "point-in-triangle",
                        "simplex",
                        "{\"triangle\":[[0,0],[8,0],[0,8]],\"points\":["
                                + repeated(100_001, "[1,2]")
                                + "]}",
                        "at most 100000 points, got 100001"));
    }

    private static String repeated(int times, String json) {
        return String.join(",", Collections.nCopies(times, json));
    }

    @Test
    void methodOfEqualStepsHasNoneForAPoint() {
        Ran.labReading(
                        "{\"kind\":\"bezier\",\"points\":[[0,0],[4,8],[8,0]],\"at\":[0.5]}",
                        "run",
                        "curve",
                        "uniform",
                        "--steps")
                .assertComplains(
                        2,
                        "./lab run: --steps: method 'uniform' has none for points at given t; give a"
                                + " flatness");
    }
}
