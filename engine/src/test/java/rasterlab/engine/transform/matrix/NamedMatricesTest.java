package rasterlab.engine.transform.matrix;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class NamedMatricesTest {
    private static final double NAN = Double.NaN;

    @Test
    void everyNameOfTheCourseIsThere() {
        var names = new HashSet<>(NamedMatrices.all().stream().map(NamedMatrix::name).toList());
        var wanted =
                List.of(
                        ("ROT2D SCALE2D SHEAR2D TRANSL2D ROT3DX ROT3DY ROT3DZ SCALE3DX SCALE3DY"
                                        + " SCALE3DZ SCALE3D REFL3DXY REFL3DYZ REFL3DZX TRANSL3D"
                                        + " ROTAXIS ORTHOX ORTHOY ORTHOZ FRONT BACK LEFT RIGHT TOP"
                                        + " BOTTOM TRIMETRIC DIMETRIC ISOMETRIC CAVALIER CABINET"
                                        + " PERSPECTIVE CENTRAL NORMALIZE VIEW_LEFT VIEW_RIGHT CANONICAL"
                                        + " LOOKAT GL_ORTHO GL_FRUSTUM GL_PERSPECTIVE VIEWPORT"
                                        + " HERMITE BEZIER")
                                .split(" "));
        for (String name : wanted) assertTrue(names.contains(name), name);
        assertEquals(NamedMatrices.all().size(), names.size());
    }

    @Test
    void usageNamesTheParametersInOrder() {
        assertEquals("ROTAXIS(through, direction, angle)", NamedMatrices.named("ROTAXIS").usage());
    }

    @Test
    void contractTellsEveryNameWithItsParameters() throws IOException {
        String contract =
                Files.readString(Path.of("src/main/java/rasterlab/contract/MatrixFormula.java"))
                        .replaceAll("\\s*\\n \\*\\s*", " ");
        for (NamedMatrix matrix : NamedMatrices.all())
            assertTrue(
                    contract.contains(matrix.usage()),
                    "MatrixFormula.java does not tell " + matrix.usage());
    }

    @Test
    void unknownNameListsTheKnownOnes() {
        var refusal =
                assertThrows(IllegalArgumentException.class, () -> NamedMatrices.named("ROT"));
        assertTrue(
                refusal.getMessage().startsWith("no matrix 'ROT'; there are IDENTITY2D, ROT2D,"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("refused")
    void refuses(String name, String message, double... numbers) {
        NamedMatrix matrix = NamedMatrices.named(name);
        var refusal = assertThrows(IllegalArgumentException.class, () -> matrix.rows(numbers));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> refused() {
        String any = " must be a finite number, got ";
        String up = "up must ";
        return Stream.of(
                refusal(
                        "NaN is an angle",
                        "ROT3DX",
                        "angle must be a finite number of degrees, got NaN",
                        NAN),
                refusal("an infinite shift", "TRANSL3D", "m" + any + "Infinity", 1, 1 / 0.0, 1),
                refusal(
                        "NaN in a point",
                        "ROTAXIS",
                        "through[1]" + any + "NaN",
                        0,
                        NAN,
                        0,
                        1,
                        0,
                        0,
                        5),
                refusal(
                        "no axis",
                        "ROTAXIS",
                        "direction must not be zero, got (0, 0, 0)",
                        1,
                        2,
                        3,
                        0,
                        0,
                        0,
                        5),
                refusal(
                        "a scale of 1/0",
                        "SCALE3D",
                        "s must be a finite number other than 0, got 0.0",
                        0),
                refusal(
                        "an eye in the plane",
                        "CENTRAL",
                        "k must be a finite number other than 0, got 0.0",
                        0),
                refusal(
                        "zmin beyond the far plane",
                        "CANONICAL",
                        "zmin must be a number above 0 and below 1, got 1.0",
                        1),
                refusal(
                        "an eye at the origin",
                        "VIEW_LEFT",
                        "rho must be a finite number above 0, got 0.0",
                        1,
                        2,
                        0),
                refusal(
                        "a box without width",
                        "GL_ORTHO",
                        "right must differ from left, got both 3.0",
                        3,
                        3,
                        0,
                        1,
                        0,
                        1),
                refusal(
                        "a negative near plane",
                        "GL_FRUSTUM",
                        "near must be a finite number above 0, got -1.0",
                        -1,
                        1,
                        -1,
                        1,
                        -1,
                        1),
                refusal(
                        "near equal to far",
                        "GL_PERSPECTIVE",
                        "far must differ from near, got both 2.0",
                        60,
                        1,
                        2,
                        2),
                refusal(
                        "a view of 180°",
                        "GL_PERSPECTIVE",
                        "fovy must be a number of degrees above 0 and below 180, got 180.0",
                        180,
                        1,
                        1,
                        2),
                refusal(
                        "a window of no height",
                        "VIEWPORT",
                        "height must be a finite number above 0, got 0.0",
                        0,
                        0,
                        9,
                        0,
                        0,
                        1),
                refusal(
                        "depth beyond 1",
                        "VIEWPORT",
                        "f must be a number from 0 to 1, got 1.5",
                        0,
                        0,
                        9,
                        9,
                        0,
                        1.5),
                refusal(
                        "an eye at the centre",
                        "LOOKAT",
                        "center must differ from eye, got both (1.0, 2.0, 3.0)",
                        1,
                        2,
                        3,
                        1,
                        2,
                        3,
                        0,
                        1,
                        0),
                refusal(
                        "no up",
                        "LOOKAT",
                        up + "not be zero, got (0.0, 0.0, 0.0)",
                        1,
                        2,
                        3,
                        0,
                        0,
                        0,
                        0,
                        0,
                        0),
                refusal(
                        "up along the look",
                        "LOOKAT",
                        up
                                + "lie at least 1.0E-8 radians off the line of sight, got (0.0, 0.0, 2.0) along (0.0, 0.0, -1.0)",
                        0,
                        0,
                        5,
                        0,
                        0,
                        0,
                        0,
                        0,
                        2),
                refusal(
                        "half the parameters",
                        "SCALE2D",
                        "SCALE2D(x, y) takes 2 numbers, got 1",
                        1),
                refusal(
                        "a cell beyond double",
                        "GL_ORTHO",
                        "GL_ORTHO: row 1, column 1 is too large for a double, its parameters being too large or too close to each other",
                        0,
                        1e-310,
                        0,
                        1,
                        0,
                        1));
    }

    private static Arguments refusal(
            String mistake, String name, String message, double... numbers) {
        return argumentSet(mistake + " is accepted", name, message, numbers);
    }

    @ParameterizedTest(name = "{0} has no inverse and is used as if it had")
    @ValueSource(strings = {"ORTHOX", "ORTHOY", "ORTHOZ", "FRONT", "CENTRAL", "CENTRAL_ORIGIN"})
    void flatteningMatricesSayThatTheyHaveNoInverse(String name) {
        NamedMatrix matrix = NamedMatrices.named(name);
        assertEquals(MatrixInverse.NONE, matrix.inverse());
        Matrix4d joml =
                WorkedMatricesTest.joml(
                        name,
                        new double[matrix.numbers()].length > 0 ? new double[] {2} : new double[0]);
        assertEquals(0, joml.determinant(), 0);
    }

    @Test
    void viewsAreTurnsOfTheWholeSpace() {
        for (String name :
                List.of("BACK", "LEFT", "RIGHT", "TOP", "BOTTOM", "DIMETRIC", "ISOMETRIC")) {
            Matrix4d view = WorkedMatricesTest.joml(name);
            assertEquals(1, view.determinant(), 1e-15, name);
            assertTrue(
                    new Matrix4d(view).transpose().mul(view).equals(new Matrix4d(), 1e-15), name);
        }
    }

    @Test
    void viewTurnsWhatStandsInItsNameTowardsTheEye() {
        assertTowardsEye("LEFT", -1, 0, 0);
        assertTowardsEye("RIGHT", 1, 0, 0);
        assertTowardsEye("TOP", 0, 1, 0);
        assertTowardsEye("BOTTOM", 0, -1, 0);
        assertTowardsEye("BACK", 0, 0, -1);
    }

    /** The eye of a parallel view looks from +z. */
    private static void assertTowardsEye(String name, double x, double y, double z) {
        double[][] m = NamedMatrices.named(name).rows();
        var image = new double[3];
        for (int j = 0; j < 3; j++) image[j] = x * m[0][j] + y * m[1][j] + z * m[2][j];
        assertArrayEquals(new double[] {0, 0, 1}, image, name);
    }
}
