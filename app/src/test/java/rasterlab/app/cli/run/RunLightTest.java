package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

/** Topics of colour, light and texture on the command line. */
class RunLightTest {
    private static final String POINT =
            "{\"normal\":[0,0,2],\"to-light\":[3,0,4],\"to-eye\":[0,0,1],\"material\":";
    private static final String FACE =
            "{\"corners\":[[0,0,0],[1,0,0],[0,1,0]],\"normals\":[[0,0,1],[0,0,1],[0,0,1]],"
                    + "\"lamp\":[0,0,4],\"eye\":[0,0,5],\"material\":{\"ambient\":[0.5,0.25,0]},"
                    + "\"global-ambient\":1,\"points\":";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("answers")
    void answers(String topic, String method, String input, String answer) {
        Ran ran = Ran.labReading(input, "run", topic, method);
        assertEquals(answer + "\n", ran.out());
        ran.assertDone();
    }

    static Stream<Arguments> answers() {
        return Stream.of(
                argumentSet(
                        "a grey has a hue",
                        "color",
                        "formula",
                        "{\"rgb\":[0,0,0]}",
                        "{\"rgb\":[0.0,0.0,0.0],\"cmy\":[1.0,1.0,1.0],\"cmyk\":[0.0,0.0,0.0,1.0],"
                                + "\"hsv\":[null,0.0,0.0],\"hvs\":[null,0.0,0.0],\"levels\":[0,0,0]}"),
                argumentSet(
                        "the answer's null is not read back",
                        "color",
                        "formula",
                        "{\"hsv\":[null,0,1]}",
                        "{\"rgb\":[1.0,1.0,1.0],\"cmy\":[0.0,0.0,0.0],\"cmyk\":[0.0,0.0,0.0,0.0],"
                                + "\"hsv\":[null,0.0,1.0],\"hvs\":[null,1.7320508075688774,0.0],"
                                + "\"levels\":[255,255,255]}"),
                argumentSet(
                        "the distance is not the vector's length",
                        "shade",
                        "lambert",
                        POINT
                                + "{\"diffuse\":0.5,\"ambient\":[1,0,0]},"
                                + "\"light\":{\"attenuation\":[0,0.2,0]},\"global-ambient\":0.25}",
                        "{\"intensity\":[0.65,0.4,0.4],\"terms\":{\"emission\":[0.0,0.0,0.0],"
                                + "\"global-ambient\":[0.25,0.0,0.0],\"ambient\":[0.0,0.0,0.0],"
                                + "\"diffuse\":[0.4,0.4,0.4],\"specular\":[0.0,0.0,0.0],"
                                + "\"attenuation\":1.0,\"cone\":1.0}}"),
                argumentSet(
                        "a face is shaded in one point only",
                        "shade-face",
                        "phong",
                        FACE + "[[1,0,0],[0,0.5,0.5]]}",
                        "{\"intensity\":[[0.5,0.25,0.0],[0.5,0.25,0.0]]}"),
                argumentSet(
                        "half the row is half of the floor",
                        "texture-mapping",
                        "perspective",
                        "{\"from\":[0,0,1],\"to\":[1,2,3],\"pixels\":3}",
                        "{\"coordinates\":[[0.0,0.0],[0.25,0.5],[1.0,2.0]]}"),
                argumentSet(
                        "the picture's top row is at t = 0",
                        "texture-filter",
                        "nearest",
                        "{\"picture\":[[10,20],[30,40]],\"pixels\":[[0.25,0.75,0,0,0,0],[0.75,0.25,0,0,0,0]]}",
                        "{\"levels\":[10,40]}"),
                argumentSet(
                        "a vertex without a face is left out",
                        "vertex-normals",
                        "angle",
                        "{\"vertices\":[[0,0,0],[2,0,0],[0,2,0],[9,9,9]],\"triangles\":[[0,1,2]]}",
                        "{\"normals\":[[0.0,0.0,1.0],[0.0,0.0,1.0],[0.0,0.0,1.0],[0.0,0.0,0.0]]}"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void complainsOf(int exitCode, String topic, String method, String input, String message) {
        Ran ran = Ran.labReading(input, "run", topic, method);
        assertEquals("", ran.out());
        assertEquals(exitCode, ran.exitCode(), ran.err());
        assertEquals("./lab run: " + message + "\n", ran.err());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a share above 1",
                        2,
                        "color",
                        "formula",
                        "{\"rgb\":[0,1.5,0]}",
                        "/rgb/1: expected a number from 0 to 1, got 1.5"),
                argumentSet(
                        "a missing share",
                        2,
                        "color",
                        "formula",
                        "{\"rgb\":[0,null,0]}",
                        "/rgb/1: expected a number from 0 to 1, got null"),
                argumentSet(
                        "two models at once",
                        2,
                        "color",
                        "formula",
                        "{\"rgb\":[0,0,0],\"cmy\":[0,0,0]}",
                        "/: expected one of rgb, cmy, cmyk, hsv, hvs, got 2 of them"),
                argumentSet(
                        "a colour outside the cube",
                        3,
                        "color",
                        "formula",
                        "{\"hvs\":[0,0,0.5]}",
                        "formula refuses: hvs lies outside the colour cube: its green would be"
                                + " -0.20412414523193154, allowed is 0 to 1"),
                argumentSet(
                        "a point without a normal",
                        3,
                        "shade",
                        "phong",
                        "{\"normal\":[0,0,0],\"to-light\":[0,0,1],\"to-eye\":[0,0,1],"
                                + "\"material\":{}}",
                        "phong refuses: normal must not be zero, got (0, 0, 0)"),
                argumentSet(
                        "a surface that sends back more than it gets",
                        2,
                        "shade",
                        "phong",
                        POINT + "{\"diffuse\":[0,2,0]}}",
                        "/material/diffuse: must have shares from 0 to 1, got (0, 2, 0)"),
                argumentSet(
                        "a cone without an axis",
                        2,
                        "shade",
                        "phong",
                        POINT + "{},\"light\":{\"spot\":{\"direction\":[0,0,0],\"cutoff\":9}}}",
                        "/light/spot/direction: must not be zero, got (0, 0, 0)"),
                argumentSet(
                        "a cone of more than a half-space",
                        2,
                        "shade",
                        "phong",
                        POINT + "{},\"light\":{\"spot\":{\"direction\":[0,0,1],\"cutoff\":91}}}",
                        "/light/spot/cutoff: must be from 0 to 90 degrees, or 180 for none, got"
                                + " 91"),
                argumentSet(
                        "light from everywhere below 0",
                        2,
                        "shade",
                        "phong",
                        POINT + "{},\"global-ambient\":[0,-1,0]}",
                        "/global-ambient: must have shares from 0 to 1000, got (0, -1, 0)"),
                argumentSet(
                        "an attenuation of 1/0",
                        2,
                        "shade",
                        "phong",
                        POINT + "{},\"light\":{\"attenuation\":[0,0,0]}}",
                        "/light/attenuation: attenuation needs a number above 0, got 0, 0 and 0"),
                argumentSet(
                        "a point beside the face",
                        2,
                        "shade-face",
                        "phong",
                        FACE + "[[1,0,0],[2,-1,0]]}",
                        "/points/1: must be weights of 0 or more with the sum 1, got (2,"
                                + " -1, 0)"),
                argumentSet(
                        "a corner is counted by its numbers",
                        2,
                        "shade-face",
                        "phong",
                        FACE.replace("[0,1,0]]", "[0,1,1e80]]") + "[[1,0,0]]}",
                        "/corners/2/2: must be from -1e75 to 1e75, got 1e80"),
                argumentSet(
                        "a normal is counted by its numbers",
                        2,
                        "shade-face",
                        "phong",
                        FACE.replaceFirst("\\[0,0,1\\],\\[0,0,1\\]", "[0,0,1],[0,-2e80,1]")
                                + "[[1,0,0]]}",
                        "/normals/1/1: must be from -1e75 to 1e75, got -2e80"),
                argumentSet(
                        "a depth behind the eye",
                        2,
                        "texture-mapping",
                        "perspective",
                        "{\"from\":[0,0,-1],\"to\":[1,2,3],\"pixels\":3}",
                        "/from/2: must be from 1e-6 to 1000000, got -1"),
                argumentSet(
                        "a short row",
                        2,
                        "texture-filter",
                        "nearest",
                        "{\"picture\":[[10,20],[30]],\"pixels\":[]}",
                        "/picture/1: expected 2 levels as /picture/0 has, got 1"),
                argumentSet(
                        "a turned footprint",
                        3,
                        "texture-filter",
                        "summed-area",
                        "{\"picture\":[[10]],\"pixels\":[[0,0,1,1,-1,1]]}",
                        "summed-area refuses: footprint must not be turned: dt/dx and ds/dy must be"
                                + " 0, got 1 and -1"),
                argumentSet(
                        "no field is named where all may be left out",
                        2,
                        "color",
                        "formula",
                        "[]",
                        "/: expected a JSON object with cmy, cmyk, hsv, hvs, rgb, got an array"),
                argumentSet(
                        "a vertex that does not exist",
                        2,
                        "vertex-normals",
                        "angle",
                        "{\"vertices\":[[0,0,0]],\"triangles\":[[0,1,2]]}",
                        "/triangles/0/1: must be a vertex from 0 to 0, got 1"),
                argumentSet(
                        "a vertex where there are none",
                        2,
                        "vertex-normals",
                        "angle",
                        "{\"vertices\":[],\"triangles\":[[0,1,2]]}",
                        "/triangles/0/0: must be a vertex, of which there are none, got 0"));
    }
}
