package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;

/** Topic hidden-surfaces by {@code ./lab run}. */
class RunHiddenSurfacesTest {
    /** Two squares that cross along a slanted line, seen from +x; y is to the right, z up. */
    private static final String VIEW =
            "{\"vertices\":[[9,-4.3,-4.3],[-9,4.4,-4.3],[-9,4.4,4.6],[9,-4.3,4.6],"
                    + "[-8,-4.3,-4.3],[8,4.4,-4.3],[9,4.4,4.6],[-9,-4.3,4.6]],"
                    + "\"faces\":[[0,1,2,3],[4,5,6]],\"theta\":0,\"phi\":90,\"rho\":100,"
                    + "\"size\":[12,8],\"projection\":\"parallel\"}";

    @ParameterizedTest(name = "{0} shows another face")
    @ValueSource(strings = {"newell", "bsp", "scanline", "warnock", "z24", "zfloat", "raycast"})
    void showsTheNearerFaceOnBothSidesOfTheLine(String method) throws Exception {
        Ran ran = Ran.labReading(VIEW, "run", "hidden-surfaces", method);
        ran.assertDone();
        JsonNode answer = new ObjectMapper().readTree(ran.out());
        assertEquals("[-1,-1,0,0,0,0,1,1,1,1,1,-1]", answer.path("picture").path(4).toString());
        boolean cuts = method.equals("newell") || method.equals("bsp");
        assertTrue(!cuts || answer.path("splits").asInt() > 0, ran.out());
        assertTrue(answer.path("work").has("pixels-written"), ran.out());
    }

    @Test
    void stepsOfWarnockAreItsWindows() throws Exception {
        Ran ran = Ran.labReading(VIEW, "run", "hidden-surfaces", "warnock", "--steps");
        JsonNode first = new ObjectMapper().readTree(ran.out()).path("steps").path(0);
        assertEquals("{\"window\":[0,0,12,8],\"divided\":true,\"decision\":2.0}", first.toString());
    }

    @Test
    void sizeOfNoPictureIsRefused() {
        Ran.labReading(VIEW.replace("[12,8]", "[0,8]"), "run", "hidden-surfaces", "zfloat")
                .assertComplains(
                        2, "./lab run: /size/0: expected a whole number from 1 to 8192, got 0");
    }

    @Test
    void aCornerThatIsNoVertexIsRefusedWhereItStands() {
        Ran.labReading(VIEW.replace("[4,5,6]", "[4,8,6]"), "run", "hidden-surfaces", "zfloat")
                .assertComplains(2, "./lab run: /faces/1/1: must be a vertex from 0 to 7, got 8");
    }

    @Test
    void aFaceWithoutAreaIsRefusedWhereItStands() {
        Ran.labReading(VIEW.replace("[4,5,6]", "[4,6,6]"), "run", "hidden-surfaces", "zfloat")
                .assertComplains(
                        2,
                        "./lab run: /faces/1: at least 3 different corners are needed, got"
                                + " [4, 6, 6]");
    }
}
