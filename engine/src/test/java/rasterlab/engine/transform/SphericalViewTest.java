package rasterlab.engine.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SphericalViewTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("views")
    void isARigidMapOfTheEyeToTheOrigin(double theta, double phi, double rho) {
        var view = new SphericalView(theta, phi, rho);
        Matrix4d matrix = view.matrix();
        assertPoint(0, 0, 0, matrix.transformPosition(view.eye()));
        assertPoint(0, 0, rho, matrix.transformPosition(new Vector3d()));
        Matrix4d turn = new Matrix4d(matrix).setTranslation(0, 0, 0);
        Matrix4d square = new Matrix4d(turn).transpose().mul(turn);
        assertEquals(0, square.sub(new Matrix4d()).determinant3x3(), 1e-12);
        assertEquals(-1, turn.determinant(), 1e-12, "left-handed");
        for (int axis = 0; axis < 3; axis++)
            assertEquals(1, turn.getColumn(axis, new Vector3d()).length(), 1e-12);
    }

    static Stream<Arguments> views() {
        return Stream.of(
                argumentSet("the translation is put in the wrong row", 0.3, 1.1, 500),
                argumentSet("θ and φ are swapped", 1.2, 0.4, 10),
                argumentSet("the view from the pole is undefined", 0.7, 0, 3),
                argumentSet("the coursework's φ beyond π is cut", Math.PI / 9, 4.18879, 500));
    }

    /** The textbook's operations in its own order: 13 of them, 8 multiplications. */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("views")
    void equalsTheTextbooksStepByStepForm(double theta, double phi, double rho) {
        double x = 3;
        double y = -5;
        double z = 7;
        double across = y * Math.cos(theta) - x * Math.sin(theta);
        double along = x * Math.cos(theta) + y * Math.sin(theta);
        Vector3d eye =
                new SphericalView(theta, phi, rho)
                        .matrix()
                        .transformPosition(new Vector3d(x, y, z));
        assertPoint(
                across,
                z * Math.sin(phi) - along * Math.cos(phi),
                rho - along * Math.sin(phi) - z * Math.cos(phi),
                eye);
    }

    @Test
    @DisplayName("upright moves the eye")
    void uprightKeepsTheEyeAndTurnsThePicture() {
        var headDown = new SphericalView(Math.PI / 9, 4 * Math.PI / 3, 500);
        SphericalView upright = headDown.upright();
        Vector3d eye = headDown.eye();
        assertPoint(eye.x, eye.y, eye.z, upright.eye());
        Vector3d point = headDown.matrix().transformPosition(new Vector3d(1, 2, 3));
        assertPoint(
                -point.x,
                -point.y,
                point.z,
                upright.matrix().transformPosition(new Vector3d(1, 2, 3)));
        assertEquals(upright, upright.upright());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(double theta, double phi, double rho, String message) {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class, () -> new SphericalView(theta, phi, rho));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        double none = Double.NaN;
        String range = "rho must be from 0.001 to 1000000 units, got ";
        return Stream.of(
                argumentSet(
                        "θ that is no number is accepted",
                        none,
                        0,
                        1,
                        "theta must be a finite angle in radians, got NaN"),
                argumentSet(
                        "infinite φ is accepted",
                        0,
                        1 / 0.0,
                        1,
                        "phi must be a finite angle in radians, got Infinity"),
                argumentSet("ρ = 0 is accepted", 0, 0, 0, range + "0.0"),
                argumentSet("negative ρ is accepted", 0, 0, -5, range + "-5.0"),
                argumentSet("ρ that is no number is accepted", 0, 0, none, range + "NaN"),
                argumentSet("a ρ without depth is accepted", 0, 0, 1e300, range + "1.0E300"));
    }

    private static void assertPoint(double x, double y, double z, Vector3d actual) {
        assertEquals(x, actual.x, 1e-9, "x");
        assertEquals(y, actual.y, 1e-9, "y");
        assertEquals(z, actual.z, 1e-9, "z");
    }
}
