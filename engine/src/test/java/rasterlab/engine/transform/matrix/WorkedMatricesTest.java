package rasterlab.engine.transform.matrix;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;
import rasterlab.engine.transform.PlaneMatrices;

/** The course's worked numbers, each test named after its place there. */
class WorkedMatricesTest {
    @Test
    void lectureTransformationOfASegment() {
        assertRows(rows(0, 1, 2, 3), rows(1, 2, 3, 1), new double[][] {{3, 1}, {11, 7}});
    }

    @Test
    void lectureCrossingSegmentsStillCross() {
        var t = rows(1, 1, 1, -1);
        assertRows(rows(-1, 2, 3, -2), t, new double[][] {{1, -3}, {1, 5}});
        assertRows(rows(-1, -2, 3, 2), t, new double[][] {{-3, 1}, {5, 1}});
        assertRows(rows(1, 0, 1, 0), t, new double[][] {{1, 1}, {1, 1}});
    }

    @Test
    void lectureTriangleTurnedBy90Degrees() {
        double[][] t90 = NamedMatrices.named("ROT2D").rows(90);
        assertArrayEquals(new double[][] {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, t90);
        double[][] triangle = {{3, -1}, {4, 1}, {2, 1}};
        double[][] turned = {{1, 3}, {-1, 4}, {-1, 2}};
        for (int i = 0; i < 3; i++) {
            var image = new Vector3d(triangle[i][0], triangle[i][1], 1).mul(joml3(t90));
            assertEquals(new Vector3d(turned[i][0], turned[i][1], 1), image);
        }
    }

    @Test
    void lectureUnitSquareGoesToTheMatrixsRows() {
        Matrix3d general = PlaneMatrices.of(2, 3, 5, 7);
        assertEquals(new Vector3d(2, 3, 1), new Vector3d(1, 0, 1).mul(general));
        assertEquals(new Vector3d(7, 10, 1), new Vector3d(1, 1, 1).mul(general));
        assertEquals(new Vector3d(5, 7, 1), new Vector3d(0, 1, 1).mul(general));
    }

    @Test
    void lectureUniformScaleIsOneOverS() {
        var image = new Vector4d(6, 4, 2, 1).mul(joml("SCALE3D", 2));
        assertEquals(new Vector4d(6, 4, 2, 2), image);
    }

    /** α = −30°, β = 20°, the textbook's figure of a trimetric house. */
    @Test
    void lectureTrimetricByMinus30And20Degrees() {
        double[][] worked = {
            {0.8660254038, -0.1710100717, 0.4698463104, 0},
            {0, 0.9396926208, 0.3420201433, 0},
            {-0.5, -0.2961981327, 0.8137976813, 0},
            {0, 0, 0, 1}
        };
        double[][] rows = NamedMatrices.named("TRIMETRIC").rows(-30, 20);
        for (int i = 0; i < 4; i++) assertArrayEquals(worked[i], rows[i], 1e-10, "row " + i);
    }

    @Test
    void lectureCavalierAndCabinetCells() {
        assertOblique(0.707106781186548, "CAVALIER");
        assertOblique(0.353553390593274, "CABINET");
    }

    private static void assertOblique(double a, String name) {
        double[][] printed = {{1, 0, 0, 0}, {0, 1, 0, 0}, {-a, -a, 1, 0}, {0, 0, 0, 1}};
        double[][] rows = NamedMatrices.named(name).rows();
        for (int i = 0; i < 4; i++) assertArrayEquals(printed[i], rows[i], 1e-15, name);
    }

    @Test
    void lectureDimetricMatrix() {
        double[][] rows = NamedMatrices.named("DIMETRIC").rows();
        double length = Math.sqrt(7.0 / 8);
        assertEquals(length, projectedLength(rows[0]), 1e-15);
        assertEquals(length, projectedLength(rows[1]), 1e-15);
        assertEquals(0.5, projectedLength(rows[2]), 1e-15);
    }

    /** The printed cells are those of sin²α = 1/8, sin²β = 1/7, the two exchanged. */
    @Test
    void lecturePrintedDimetricMatrixShortensXAndYUnequally() {
        double[][] printed = new AppendixFormula().rows("DIMETRIC");
        assertEquals(0.945, projectedLength(printed[0]), 5e-4);
        assertEquals(0.926, projectedLength(printed[1]), 5e-4);
        assertEquals(0.5, projectedLength(printed[2]), 1e-14);
    }

    @Test
    void lectureIsometricMatrix() {
        double a = 0.707106781186548;
        double b = 0.408248290463863;
        double c = 0.577350269189626;
        double d = 0.816496580927726;
        double[][] rows = NamedMatrices.named("ISOMETRIC").rows();
        double[][] printed = {{a, b, -c, 0}, {0, d, c, 0}, {a, -b, c, 0}, {0, 0, 0, 1}};
        double[][] appendix = new AppendixFormula().rows("ISOMETRIC");
        for (int i = 0; i < 4; i++) {
            assertArrayEquals(printed[i], rows[i], 1e-15, "row " + i);
            assertArrayEquals(printed[i], appendix[i], "printed row " + i);
        }
        for (int i = 0; i < 3; i++)
            assertEquals(Math.sqrt(2 / 3.0), projectedLength(rows[i]), 1e-15);
    }

    /** α = 22.2077° as for dimetry and β = 45° shorten the axes by three different lengths. */
    @Test
    void lecturePrintedIsometricAnglesAreNotIsometric() {
        double[][] rows = NamedMatrices.named("TRIMETRIC").rows(AppendixFormula.ALPHA, 45);
        assertEquals(Math.sqrt(13.0 / 14), projectedLength(rows[0]), 1e-15);
        assertEquals(Math.sqrt(1.0 / 2), projectedLength(rows[1]), 1e-15);
        assertEquals(Math.sqrt(4.0 / 7), projectedLength(rows[2]), 1e-15);
    }

    @Test
    void lectureIsometricXAxisMakes30DegreesWithTheHorizontal() {
        double[] x = NamedMatrices.named("ISOMETRIC").rows()[0];
        assertEquals(30, Math.toDegrees(Math.atan2(x[1], x[0])), 1e-12);
    }

    @Test
    void lectureAnglesOfDimetryAndIsometry() {
        double[][] dimetric =
                NamedMatrices.named("TRIMETRIC").rows(22.207654298596488, 20.70481105463543);
        double[][] isometric = NamedMatrices.named("TRIMETRIC").rows(45, 35.264389682754654);
        for (int i = 0; i < 4; i++) {
            assertArrayEquals(NamedMatrices.named("DIMETRIC").rows()[i], dimetric[i], 1e-15);
            assertArrayEquals(NamedMatrices.named("ISOMETRIC").rows()[i], isometric[i], 1e-15);
        }
    }

    @Test
    void lectureQuestionViewFromTheNorthPole() {
        double[][] expected = {{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}, {0, 0, 10, 1}};
        double[][] rows = NamedMatrices.named("VIEW_LEFT").rows(0, 0, 10);
        for (int i = 0; i < 4; i++) assertArrayEquals(expected[i], rows[i]);
    }

    @Test
    void lectureRightHandedViewTurnsYRoundOnly() {
        double[][] left = NamedMatrices.named("VIEW_LEFT").rows(20, 70, 400);
        double[][] right = NamedMatrices.named("VIEW_RIGHT").rows(20, 70, 400);
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                assertEquals(j == 1 ? 0.0 - left[i][j] : left[i][j], right[i][j]);
        assertEquals(-1, joml("VIEW_LEFT", 20, 70, 400).determinant(), 1e-14);
        assertEquals(1, joml("VIEW_RIGHT", 20, 70, 400).determinant(), 1e-14);
    }

    /** The screen is 8 by 6 at z = 2, seen up to z = 20 and from z = 5 on. */
    @Test
    void chapter5NormalAndThenCanonicalTakeThePyramidToTheBox() {
        Matrix4d both = joml("CANONICAL", 0.25).mul(joml("NORMALIZE", 2, 4, 3, 20));
        for (double z : new double[] {5, 20})
            for (double side : new double[] {-1, 0, 1}) {
                var corner = new Vector4d(side * 4 * z / 2, -side * 3 * z / 2, z, 1).mul(both);
                corner.div(corner.w);
                assertEquals(side, corner.x, 1e-15);
                assertEquals(-side, corner.y, 1e-15);
                assertEquals(z == 5 ? 0 : 1, corner.z, 1e-15);
            }
    }

    @Test
    void chapter5CanonicalVolumeTakesTheNearCornerToOneOneZero() {
        double zMin = 0.25;
        var corner = new Vector4d(zMin, zMin, zMin, 1).mul(joml("CANONICAL", zMin));
        assertEquals(new Vector4d(1, 1, 0, 1), corner.div(corner.w));
    }

    @Test
    void chapter2CentralProjectionDividesByZPlusK() {
        var image = new Vector4d(3, 4, 5, 1).mul(joml("CENTRAL", 10));
        assertEquals(2, image.x / image.w, 1e-15);
        assertEquals(40.0 / 15, image.y / image.w, 1e-15);
        image = new Vector4d(3, 4, 5, 1).mul(joml("CENTRAL_ORIGIN", 10));
        assertEquals(new Vector4d(30, 40, 0, 5), image);
    }

    @Test
    void chapter8HermiteTimesHermiteBezierIsBezier() {
        Matrix4d product = joml("HERMITE_BEZIER").mul(joml("HERMITE"));
        assertEquals(joml("BEZIER"), product);
    }

    private static double projectedLength(double[] row) {
        return Math.hypot(row[0], row[1]);
    }

    private static double[][] rows(double a, double b, double c, double d) {
        return new double[][] {{a, b}, {c, d}};
    }

    /** Row points times a 2×2 matrix, through the 3×3 matrix that has it in its corner. */
    private static void assertRows(double[][] points, double[][] t, double[][] expected) {
        Matrix3d matrix = PlaneMatrices.of(t[0][0], t[0][1], t[1][0], t[1][1]);
        for (int i = 0; i < 2; i++)
            assertEquals(
                    new Vector3d(expected[i][0], expected[i][1], 1),
                    new Vector3d(points[i][0], points[i][1], 1).mul(matrix));
    }

    static Matrix4d joml(String name, double... numbers) {
        double[][] rows = NamedMatrices.named(name).rows(numbers);
        var cells = new double[16];
        for (int i = 0; i < 16; i++) cells[i] = rows[i / 4][i % 4];
        return new Matrix4d().set(cells);
    }

    private static Matrix3d joml3(double[][] rows) {
        var cells = new double[9];
        for (int i = 0; i < 9; i++) cells[i] = rows[i / 3][i % 3];
        return new Matrix3d().set(cells);
    }
}
