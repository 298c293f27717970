package rasterlab.engine.visibility.triangle;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.study.Deviation;

class DepthTriangleTest {
    private static final DepthTriangleTopic TOPIC = new DepthTriangleTopic();
    private static final double[] TALL = {5, 0, 0.85, 8, 4, 0.6, 0, 4, 0.2};

    /** A wall and another that is a little nearer or farther, in a picture of one pixel. */
    private static DepthTriangles walls(double first, double second) {
        return new DepthTriangles(List.of(wall(first), wall(second)), 1, 1, 1);
    }

    private static double[] wall(double depth) {
        return new double[] {-1, -1, depth, 3, -1, depth, -1, 3, depth};
    }

    private static DepthTriangleFiller method(String name) {
        return TOPIC.method(name).implementation();
    }

    @ParameterizedTest
    @ValueSource(strings = {"rows", "weights", "slopes"})
    void nearerPixelsAloneAreWrittenWithTheDepthsOfTheirCenters(String name) {
        var input = new DepthTriangles(List.of(TALL), 10, 6, 0.625);
        DepthTriangles.TrianglePicture picture = TOPIC.run(method(name), input, Integer.MAX_VALUE);
        int[] shown = new int[60];
        double[] depths = DepthTriangles.TrianglePicture.empty(input).depths();
        for (int x = 3; x <= 4; x++) depths[20 + x] = 0.55 + 0.05 * (x - 3);
        for (int x = 2; x <= 6; x++) depths[30 + x] = 0.4 + 0.05 * (x - 2);
        for (int at = 0; at < 60; at++) if (depths[at] < 0.625) shown[at] = 1;
        assertArrayEquals(shown, picture.shown());
        assertArrayEquals(depths, picture.depths(), 1e-12);
    }

    @Test
    void fromTheLeftEdgeARowBeginsWithAnotherDepth() {
        var input = new DepthTriangles(List.of(TALL), 10, 6, 1);
        DepthTriangles.TrianglePicture picture =
                TOPIC.run(method("left-edge-textbook"), input, Integer.MAX_VALUE);
        assertEquals(0.525, picture.depths()[23], 1e-12);
    }

    @ParameterizedTest(name = "{0} and {1}, where the farther one is shown")
    @CsvSource({"0.5, 0.5000000000000001, true", "0.5, 0.50000001, false"})
    void eitherOfTwoTrianglesIsRightWhereRoundingAloneDecides(
            double first, double second, boolean right) {
        DepthTriangles input = walls(first, second);
        DepthTriangles.TrianglePicture exact = TOPIC.exact(input, Integer.MAX_VALUE);
        var other = new DepthTriangles.TrianglePicture(1, new int[] {2}, exact.depths());
        assertEquals(right, TOPIC.correct(TOPIC.compare(input, exact, other)));
    }

    @Test
    void theSameCornersAgainAreNeverShown() {
        DepthTriangles input = walls(0.3, 0.3);
        DepthTriangles.TrianglePicture exact = TOPIC.exact(input, Integer.MAX_VALUE);
        assertArrayEquals(new int[] {1}, exact.shown());
        var later = new DepthTriangles.TrianglePicture(1, new int[] {2}, exact.depths());
        assertFalse(TOPIC.correct(TOPIC.compare(input, exact, later)));
    }

    @Test
    void aDepthThatIsNoNumberIsWrong() {
        DepthTriangles input = walls(0.3, 0.6);
        DepthTriangles.TrianglePicture exact = TOPIC.exact(input, Integer.MAX_VALUE);
        var none = new DepthTriangles.TrianglePicture(1, exact.shown(), new double[] {Double.NaN});
        Deviation deviation = TOPIC.compare(input, exact, none);
        assertFalse(TOPIC.usable(deviation));
        assertEquals("depth at pixel (0, 0) is NaN, right is 0.3", deviation.first());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0.3 | 0 | triangles[0][0].x must be a multiple of 1/256, got 0.3",
                "-4097 | 0 | triangles[0][0].x must be from -4096 to 4096, got -4097.0",
                "0 | 1.5 | triangles[0][0].z must be from 0 to 1, got 1.5"
            })
    void anInputOutsideItsRangeIsRefusedWithPlaceAndValue(double x, double z, String said) {
        double[] corners = {x, 0, z, 1, 0, 0, 0, 1, 0};
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new DepthTriangles(List.of(corners), 4, 4, 1));
        assertTrue(refused.getMessage().equals(said), refused.getMessage());
    }
}
