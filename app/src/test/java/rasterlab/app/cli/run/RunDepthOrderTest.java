package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Topic depth-order by {@code ./lab run}. */
class RunDepthOrderTest {
    private static final String TWO =
            "{\"polygons\":[[[-1,-1,5],[1,-1,5],[0,1,5]],[[-1,-1,9],[1,-1,9],[0,1,9]]],"
                    + "\"eye\":[0,0,0]}";
    private static final String CROSSING =
            "{\"polygons\":[[[-4,-2,20],[4,-2,20],[4,2,20],[-4,2,20]],"
                    + "[[-4,-2,16],[4,-2,24],[4,2,24],[-4,2,16]]],\"eye\":[0,0,0]}";

    @ParameterizedTest(name = "farther one is painted last: {0}")
    @MethodSource("methods")
    void paintsTheFartherFirst(String method) {
        Ran ran = Ran.labReading(TWO, "run", "depth-order", method);
        assertEquals("{\"order\":[1,0],\"splits\":[]}\n", ran.out());
        ran.assertDone();
    }

    static Stream<String> methods() {
        return Stream.of("mean-z-textbook", "mean-z", "newell", "bsp");
    }

    @Test
    void cutPolygonsAreNamedByTheirPieces() {
        Ran ran = Ran.labReading(CROSSING, "run", "depth-order", "bsp");
        assertEquals(
                "{\"order\":[2,0,3],\"splits\":["
                        + "{\"polygon\":1,\"corners\":[[0.0,-2.0,20.0],[4.0,-2.0,24.0],"
                        + "[4.0,2.0,24.0],[0.0,2.0,20.0]]},"
                        + "{\"polygon\":1,\"corners\":[[-4.0,-2.0,16.0],[0.0,-2.0,20.0],"
                        + "[0.0,2.0,20.0],[-4.0,2.0,16.0]]}]}\n",
                ran.out());
        ran.assertDone();
    }

    @Test
    void stepsTellMovesCutsAndPaintings() {
        Ran ran = Ran.labReading(TWO, "run", "depth-order", "mean-z", "--steps");
        assertEquals(
                "{\"order\":[1,0],\"splits\":[],\"decision\":\"mean depth z of the corners, in units"
                        + " of the input\",\"steps\":[{\"paint\":1,\"decision\":9.0},"
                        + "{\"paint\":0,\"decision\":5.0}]}\n",
                ran.out());
        ran.assertDone();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(int code, String json, String message) {
        Ran.labReading(json, "run", "depth-order", "newell")
                .assertComplains(code, "./lab run: " + message);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "two corners are a polygon",
                        2,
                        "{\"polygons\":[[[0,0,5],[1,0,5]]],\"eye\":[0,0,0]}",
                        "/polygons/0: only 2 values; expected an array of 3 to 1000000 points of 3"
                                + " numbers each"),
                argumentSet(
                        "polygon without area is painted",
                        3,
                        "{\"polygons\":[[[0,0,5],[1,1,5],[2,2,5]]],\"eye\":[0,0,0]}",
                        "newell refuses: polygon 0: corners [0, 1, 2] span no area"),
                argumentSet(
                        "polygon behind the eye is projected",
                        3,
                        "{\"polygons\":[[[0,0,-1],[1,0,5],[0,1,5]]],\"eye\":[0,0,0]}",
                        "newell refuses: polygon 0, corner 0 must be in front of the eye, which"
                                + " looks at the middle of the box round all; clip the polygons"
                                + " first"));
    }
}
