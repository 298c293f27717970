package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/** Topics matrix, transform, rotate and rotate-axis on the command line. */
class TransformRunTest {
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
                        "a homogeneous point is refused",
                        "transform",
                        "double",
                        "{\"points\":[[0,0,1,0],[2,4,6,2],[1,2,3]]}",
                        "{\"points\":[null,[1.0,2.0,3.0],[1.0,2.0,3.0]],\"h\":[0.0,2.0,1.0]}"),
                argumentSet(
                        "a direction has no vanishing point",
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"PERSPECTIVE\",\"p\":0,\"q\":0,\"r\":0.25}],"
                                + "\"points\":[[0,0,1,0]]}",
                        "{\"points\":[[0.0,0.0,4.0]],\"h\":[0.25]}"),
                argumentSet(
                        "a right angle has dust beside its zeros",
                        "matrix",
                        "formula",
                        "{\"name\":\"ROT3DX\",\"angle\":90}",
                        "{\"matrix\":[[1.0,0.0,0.0,0.0],[0.0,0.0,1.0,0.0],[0.0,-1.0,0.0,0.0],[0.0,0.0,0.0,1.0]]}"),
                argumentSet(
                        "the plane's matrices have four rows",
                        "matrix",
                        "formula",
                        "{\"m\":5,\"n\":7,\"name\":\"TRANSL2D\"}",
                        "{\"matrix\":[[1.0,0.0,0.0],[0.0,1.0,0.0],[5.0,7.0,1.0]]}"),
                argumentSet(
                        "the depth range has no default",
                        "matrix",
                        "formula",
                        "{\"name\":\"VIEWPORT\",\"x\":0,\"y\":0,\"width\":8,\"height\":6}",
                        "{\"matrix\":[[4.0,0.0,0.0,0.0],[0.0,3.0,0.0,0.0],[0.0,0.0,0.5,0.0],[4.0,3.0,0.5,1.0]]}"),
                argumentSet(
                        "OpenGL's matrix is printed for columns",
                        "matrix",
                        "formula",
                        "{\"name\":\"GL_FRUSTUM\",\"left\":-1,\"right\":1,\"bottom\":-1,\"top\":1,\"near\":1,\"far\":3}",
                        "{\"matrix\":[[1.0,0.0,0.0,0.0],[0.0,1.0,0.0,0.0],[0.0,0.0,-2.0,-1.0],[0.0,0.0,-3.0,0.0]]}"),
                argumentSet(
                        "the list is applied right to left",
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"TRANSL2D\",\"m\":1,\"n\":0},[[0,1,0],[-1,0,0],[0,0,1]]],\"points\":[[2,0]]}",
                        "{\"points\":[[0.0,3.0]],\"h\":[1.0]}"),
                argumentSet(
                        "a point at infinity is written as one",
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"PERSPECTIVE\",\"p\":0,\"q\":0,\"r\":0.5}],\"points\":[[1,2,-2],[1,2,-4]]}",
                        "{\"points\":[null,[-1.0,-2.0,4.0]],\"h\":[0.0,-1.0]}"),
                argumentSet(
                        "no point is an error",
                        "transform",
                        "float",
                        "{\"matrices\":[],\"points\":[]}",
                        "{\"points\":[],\"h\":[]}"),
                argumentSet(
                        "the view from the pole is turned",
                        "view",
                        "taken-apart",
                        "{\"points\":[[1,2,3]],\"theta\":0,\"phi\":0,\"rho\":10}",
                        "{\"points\":[[2.0,-1.0,7.0]]}"),
                argumentSet(
                        "one turn is not the default",
                        "rotate",
                        "direct",
                        "{\"points\":[[3,-1],[4,1],[2,1]],\"degrees\":90}",
                        "{\"points\":[[1.0,3.0],[-1.0,4.0],[-1.0,2.0]]}"),
                argumentSet(
                        "the turns are not repeated",
                        "rotate",
                        "buneman",
                        "{\"points\":[[3,4]],\"degrees\":180,\"times\":3}",
                        "{\"points\":[[-3.0,-4.0]]}"),
                argumentSet(
                        "an axis along z has no answer",
                        "rotate-axis",
                        "seven-steps",
                        "{\"points\":[[1,0,7]],\"through\":[0,0,0],\"direction\":[0,0,2],\"degrees\":90}",
                        "{\"points\":[[0.0,1.0,7.0]]}"),
                argumentSet(
                        "0/0 is printed as a number",
                        "rotate-axis",
                        "seven-steps-textbook",
                        "{\"points\":[[1,0,7]],\"through\":[0,0,0],\"direction\":[0,0,2],\"degrees\":90}",
                        "{\"points\":[[null,null,null]]}"));
    }

    @Test
    void sevenStepsShowWhereThePointsAreAfterEach() throws Exception {
        String input =
                "{\"points\":[[1,2,2]],\"through\":[0,0,0],\"direction\":[1,2,2],\"degrees\":37}";
        Ran ran = Ran.labReading(input, "run", "rotate-axis", "seven-steps", "--steps");
        JsonNode steps = new ObjectMapper().readTree(ran.out()).path("steps");
        assertEquals(7, steps.size());
        assertEquals(3, steps.get(2).path("points").get(0).get(2).asDouble(), 1e-14);
        assertTrue(steps.get(2).path("step").asText().contains("axis onto z"), ran.out());
    }

    @Test
    void stagesOfAListShowThePointsAfterEachMatrix() throws Exception {
        String input =
                "{\"matrices\":[{\"name\":\"SCALE3D\",\"s\":0.5},{\"name\":\"TRANSL3D\",\"l\":1,\"m\":0,\"n\":0}],"
                        + "\"points\":[[1,2,3]]}";
        Ran ran = Ran.labReading(input, "run", "transform", "double", "--steps");
        JsonNode steps = new ObjectMapper().readTree(ran.out()).path("steps");
        assertEquals("[[1.0,2.0,3.0]]", steps.get(0).path("points").toString());
        assertEquals("[[2.0,4.0,6.0]]", steps.get(1).path("points").toString());
        assertEquals("[[3.0,4.0,6.0]]", steps.get(2).path("points").toString());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("complaints")
    void complains(int exit, String topic, String method, String input, String line) {
        Ran ran = Ran.labReading(input, "run", topic, method);
        ran.assertComplains(exit, "./lab run: " + line);
    }

    static Stream<Arguments> complaints() {
        String axis = "\"points\":[],\"degrees\":1,\"through\":[0,0,0],\"direction\":";
        return Stream.of(
                argumentSet(
                        "no name",
                        2,
                        "matrix",
                        "formula",
                        "{\"angle\":1}",
                        "/name: missing; expected one of "
                                + NamedMatrices.all().stream()
                                        .map(NamedMatrix::name)
                                        .collect(Collectors.joining(", "))),
                argumentSet(
                        "a missing angle is 0",
                        2,
                        "matrix",
                        "formula",
                        "{\"name\":\"ROT3DX\"}",
                        "/angle: missing; expected a finite number of degrees"),
                argumentSet(
                        "a foreign parameter is overlooked",
                        2,
                        "matrix",
                        "formula",
                        "{\"name\":\"ROT3DX\",\"angle\":1,\"k\":2}",
                        "/k: ROT3DX has no such parameter; allowed are angle"),
                argumentSet(
                        "the fields of all matrices are listed",
                        2,
                        "matrix",
                        "formula",
                        "{\"foo\":[2,{}],\"name\":\"ROT3DX\",\"angle\":1}",
                        "/foo: ROT3DX has no such parameter; allowed are angle"),
                argumentSet(
                        "the fields of all matrices are listed in a list",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"BEZIER\",\"foo\":3}],\"points\":[]}",
                        "/matrices/0/foo: BEZIER has no such parameter; it has none"),
                argumentSet(
                        "up that is nearly along the sight is said to lie along it",
                        3,
                        "matrix",
                        "formula",
                        "{\"name\":\"LOOKAT\",\"eye\":[10,38,2],\"center\":[10,8,2.000000001],\"up\":[0,1,0]}",
                        "formula refuses: up must lie at least 1e-8 radians off the line of sight, got"
                                + " (0, 1, 0) along (0, -1, 3.33333360913457e-11)"),
                argumentSet(
                        "a value out of range",
                        2,
                        "matrix",
                        "formula",
                        "{\"name\":\"CANONICAL\",\"zmin\":1}",
                        "/zmin: must be a number above 0 and below 1, got 1"),
                argumentSet(
                        "a flat point",
                        2,
                        "matrix",
                        "formula",
                        "{\"name\":\"LOOKAT\",\"eye\":[0,0]}",
                        "/eye: only 2 values; expected an array of 3 numbers"),
                argumentSet(
                        "two sides that meet",
                        3,
                        "matrix",
                        "formula",
                        "{\"name\":\"GL_ORTHO\",\"left\":1,\"right\":1,\"bottom\":0,\"top\":1,\"near\":0,\"far\":1}",
                        "formula refuses: right must differ from left, got both 1"),
                argumentSet(
                        "a number in place of a matrix might have been rows only",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[7],\"points\":[]}",
                        "/matrices/0: expected a matrix: an object with its name, or an array of 3 or"
                                + " 4 rows"),
                argumentSet(
                        "a distance in words might have been negative",
                        2,
                        "view",
                        "taken-apart",
                        "{\"points\":[],\"theta\":1,\"phi\":2,\"rho\":\"far\"}",
                        "/rho: expected a number above 0, up to 1.0715086071862673e301, got the"
                                + " string \"far\""),
                argumentSet(
                        "a bad matrix in a list has no place",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"IDENTITY\"},{\"name\":\"SCALE3D\",\"s\":0}],\"points\":[]}",
                        "/matrices/1/s: must be a finite number other than 0, got 0"),
                argumentSet(
                        "a list crashes on what a matrix refuses",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"ROTAXIS\",\"through\":[0,0,0],\"direction\":[0,0,0],\"angle\":1}],\"points\":[]}",
                        "/matrices/0/direction: must not be zero, got (0, 0, 0)"),
                argumentSet(
                        "three rows of four",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[[[1,0,0,0],[0,1,0,0],[0,0,1,0]]],\"points\":[]}",
                        "/matrices/0/0: expected 3 numbers, as many as the matrix has rows, got 4"),
                argumentSet(
                        "the plane and space are mixed",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"IDENTITY\"},{\"name\":\"ROT2D\",\"angle\":1}],\"points\":[]}",
                        "/matrices/1: expected 4 rows as /matrices/0 has, got 3"),
                argumentSet(
                        "a point of the plane in space",
                        2,
                        "transform",
                        "double",
                        "{\"matrices\":[{\"name\":\"IDENTITY\"}],\"points\":[[1,2,3],[1,2]]}",
                        "/points/1: expected 3 numbers, one less than the matrices have rows, or 4, with h, got 2"),
                argumentSet(
                        "turns without end",
                        2,
                        "rotate",
                        "table",
                        "{\"points\":[],\"degrees\":1,\"times\":10000001}",
                        "/times: expected a whole number from 0 to 10000000, got 10000001"),
                argumentSet(
                        "no axis",
                        3,
                        "rotate-axis",
                        "quaternion",
                        "{" + axis + "[0,0,0]}",
                        "quaternion refuses: direction must not be zero, got (0, 0, 0)"));
    }

    @Test
    void methodsListEveryMatrixWithItsParameters() {
        Ran ran = Ran.lab("methods", "matrix");
        for (String usage :
                new String[] {
                    "ROTAXIS(through, direction, angle)",
                    "GL_PERSPECTIVE(fovy, aspect, near, far)",
                    "CANONICAL(zmin)",
                    "BEZIER",
                    "ISOMETRIC",
                    "VIEWPORT(x, y, width, height, n, f)"
                }) assertTrue(ran.out().contains(usage), usage);
        ran.assertDone();
    }
}
