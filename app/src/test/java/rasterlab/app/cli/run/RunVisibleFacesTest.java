package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Topic visible-faces by {@code ./lab run}. */
class RunVisibleFacesTest {
    private static final String VERTICES = "\"vertices\":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]";
    private static final String FACES = "\"faces\":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("answers")
    void answers(String method, String rest, String answer) {
        String json = "{" + VERTICES + "," + FACES + "," + rest + "}";
        Ran ran = Ran.labReading(json, "run", "visible-faces", method);
        assertEquals("{\"visible\":" + answer + "}\n", ran.out());
        ran.assertDone();
    }

    static Stream<Arguments> answers() {
        return Stream.of(
                argumentSet(
                        "back faces are seen",
                        "back-face",
                        "\"eye\":[2,3,4]",
                        "[false,false,false,true]"),
                argumentSet(
                        "mean of the vertices is not inside",
                        "convex-segment",
                        "\"eye\":[2,-3,-4]",
                        "[true,true,false,false]"),
                argumentSet(
                        "inner point is not read",
                        "convex-segment-textbook",
                        "\"eye\":[2,3,4],\"inside\":[1,1,1]",
                        "[false,false,false,false]"));
    }

    @Test
    void stepsTellWhereTheSegmentIsCut() {
        String json = "{" + VERTICES + ",\"faces\":[[0,2,1]],\"eye\":[0.25,0.25,-0.75]}";
        Ran ran = Ran.labReading(json, "run", "visible-faces", "convex-segment", "--steps");
        assertEquals(
                "{\"visible\":[true],\"decision\":\"μ = (c − n·A) / (n·(B − A)) of the plane on the"
                        + " segment from the eye A to the inner point B, visible where A and B are"
                        + " on two sides\",\"steps\":[{\"face\":0,\"decision\":0.75,\"visible\":true}"
                        + "]}\n",
                ran.out());
        ran.assertDone();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(int code, String json, String message) {
        Ran.labReading("{" + VERTICES + "," + json + "}", "run", "visible-faces", "convex-segment")
                .assertComplains(code, "./lab run: " + message);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "corner past the vertices is read",
                        2,
                        "\"faces\":[[0,1,2],[1,4,2]],\"eye\":[1,2,3]",
                        "/faces/1/1: must be a vertex from 0 to 3, got 4"),
                argumentSet(
                        "two corners are a face",
                        2,
                        "\"faces\":[[0,1]],\"eye\":[1,2,3]",
                        "/faces/0: only 2 values; expected an array of 3 to 1000000 vertex"
                                + " numbers"),
                argumentSet(
                        "any point is taken for an inner one",
                        3,
                        FACES + ",\"eye\":[1,2,3],\"inside\":[0.25,0.25,-1]",
                        "convex-segment refuses: inside must be behind every face, but [0.25, 0.25,"
                                + " -1] lies in front of face 0; give an inner point of a convex"
                                + " body, its faces counter-clockwise seen from outside"));
    }
}
