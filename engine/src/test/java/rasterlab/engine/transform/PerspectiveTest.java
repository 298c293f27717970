package rasterlab.engine.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Amount of perspective, vanishing points and the stereo pair. */
class PerspectiveTest {
    @Test
    void lectureGammaIsWhatThePictureShowsAtAnyScreenDistance() {
        for (double z : new double[] {0.5, 1, 2, 3, 10, 222})
            for (double d : new double[] {1, 200, 400})
                assertEquals(
                        PerspectiveAmount.gamma(z, 1.5),
                        measured(z, 1.5, 7, d),
                        1e-9 * PerspectiveAmount.gamma(z, 1.5));
    }

    /** γ in a picture at distance d, from the images of the three ends. */
    private static double measured(double distance, double depth, double height, double d) {
        double near = height * d / distance;
        double middle = height * d / (distance + depth);
        double far = height * d / (distance + 2 * depth);
        return (near - middle) / (middle - far);
    }

    @Test
    void lectureGammaRunsAwayBelowTwoToThreeDepths() {
        List<PerspectiveAmount.PerspectiveSample> chart = PerspectiveAmount.chart(0.5, 10, 20);
        assertEquals(20, chart.size());
        assertEquals(5, chart.get(0).gamma());
        assertEquals(1.2, chart.get(19).gamma(), 1e-15);
        assertEquals(2, PerspectiveAmount.gamma(2, 1));
        for (int i = 1; i < 20; i++)
            assertTrue(chart.get(i).gamma() < chart.get(i - 1).gamma(), "sample " + i);
    }

    @Test
    @DisplayName("γ of a point at the eye is infinite")
    void refusesAPointAtTheEye() {
        var eye = assertThrows(IllegalArgumentException.class, () -> PerspectiveAmount.gamma(0, 1));
        assertEquals("distance must be a finite number above 0, got 0.0", eye.getMessage());
        assertThrows(IllegalArgumentException.class, () -> PerspectiveAmount.gamma(1, -1));
        assertThrows(IllegalArgumentException.class, () -> PerspectiveAmount.chart(1, 1, 9));
        assertThrows(IllegalArgumentException.class, () -> PerspectiveAmount.chart(1, 2, 1));
    }

    @Test
    void lectureVanishingPointsAndCentersOfProjection() {
        Matrix4d three = ProjectionMatrices.perspective(0.5, 0.25, -0.125);
        assertEquals(Optional.of(new Vector3d(2, 0, 0)), VanishingPoints.of(three, 0));
        assertEquals(Optional.of(new Vector3d(0, 4, 0)), VanishingPoints.of(three, 1));
        assertEquals(Optional.of(new Vector3d(0, 0, -8)), VanishingPoints.of(three, 2));
        assertEquals(Optional.of(new Vector3d(-2, 0, 0)), VanishingPoints.center(three, 0));
        assertEquals(Optional.of(new Vector3d(0, 0, 8)), VanishingPoints.center(three, 2));
        assertEquals(3, vanishingPoints(three));
        assertEquals(1, vanishingPoints(ProjectionMatrices.perspective(0, 0, 1)));
        assertEquals(0, vanishingPoints(ProjectionMatrices.isometric()));
        assertThrows(IllegalArgumentException.class, () -> VanishingPoints.of(three, 3));
    }

    /** One, two or three vanishing points of the axes name the perspective. */
    private static long vanishingPoints(Matrix4d projection) {
        return IntStream.range(0, 3)
                .filter(axis -> VanishingPoints.of(projection, axis).isPresent())
                .count();
    }

    @Test
    void farPointsOfParallelLinesComeCloseToTheVanishingPoint() {
        Matrix4d one = ProjectionMatrices.perspective(0, 0, 0.25);
        for (double x : new double[] {-3, 0, 5}) {
            var far = new Vector4d(x, 7, 1e12, 1).mul(one);
            assertEquals(0, far.x / far.w, 1e-9);
            assertEquals(4, far.z / far.w, 1e-9);
        }
    }

    @Test
    @DisplayName("the eyes see the same picture, or change places")
    void parallaxIsZeroInThePicturePlaneAndGrowsBehindIt() {
        var middle = new SphericalView(0.7, 1.1, 50);
        var pair = new StereoPair(middle, 6);
        for (Vector3d world :
                List.of(new Vector3d(), new Vector3d(3, -8, 5), new Vector3d(-20, -9, -20))) {
            double depth = middle.matrix().transformPosition(new Vector3d(world)).z;
            Vector4d left = new Vector4d(world, 1).mul(pair.left());
            Vector4d right = new Vector4d(world, 1).mul(pair.right());
            double parallax = left.x / left.w - right.x / right.w;
            assertEquals(6 * (50 / depth - 1), parallax, 1e-12);
            assertEquals(left.y / left.w, right.y / right.w, 1e-12, "no vertical parallax");
        }
    }

    @Test
    @DisplayName("one eye or none is accepted")
    void refusesEyesInOnePlace() {
        var middle = new SphericalView(0, 1, 50);
        for (double separation : new double[] {0, -1, Double.NaN, 1e9}) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> new StereoPair(middle, separation));
            assertEquals(
                    "separation must be above 0, up to 1000000 units, got " + separation,
                    refusal.getMessage());
        }
    }

    @Test
    void lectureSizeStaysWhenTheScreenStandsAtTheOrigin() {
        for (double rho : new double[] {190, 260, 300, 400}) {
            assertEquals(5, sizeOnScreen(rho, rho), 1e-12, "d = ρ");
            assertEquals(5 * 200 / rho, sizeOnScreen(rho, 200), 1e-12, "d = 200");
        }
    }

    /** X of the image of (0, 5, 0), seen from (ρ, 0, 0) on a screen at distance d. */
    private static double sizeOnScreen(double rho, double d) {
        var image =
                new Vector4d(0, 5, 0, 1)
                        .mul(new SphericalView(0, Math.PI / 2, rho).matrix())
                        .mul(ProjectionMatrices.centralFromOrigin(d));
        return image.x / image.w;
    }
}
