package rasterlab.engine.transform.matrix;

import rasterlab.contract.MatrixFormula;
import rasterlab.engine.transform.axis.SevenStepsTextbook;

/**
 * The matrices as the course's appendix prints them, misprints included; those that it prints right
 * or not at all come from the right formula.
 *
 * <p>SCALE3DY, SCALE3DZ, SCALE3D and TRANSL3D have zeros on the diagonal where ones belong, so that
 * they flatten space; the cells of DIMETRIC have its two angles exchanged; those of ISOMETRIC are
 * right, though the angles printed beside them are not; ROTAXIS follows the printed seven steps,
 * which do not bring the axis onto z.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, appendix and
 * p. 21, rotation about a line.
 */
public final class AppendixFormula implements MatrixFormula {
    /**
     * The angle printed as α for DIMETRIC, where it is right, and for ISOMETRIC, where 45° would
     * be.
     */
    static final double ALPHA = 22.207654298596487;

    @Override
    public double[][] rows(String name, double... parameters) {
        NamedMatrix matrix = NamedMatrices.named(name);
        matrix.require(parameters);
        double first = parameters.length > 0 ? parameters[0] : 0;
        return switch (name) {
            case "SCALE3DY" -> diagonal(0, first, 1, 1);
            case "SCALE3DZ" -> diagonal(0, 0, first, 1);
            case "SCALE3D" -> diagonal(0, 0, 0, first);
            case "TRANSL3D" -> {
                double[][] rows = diagonal(0, 0, 0, 1);
                System.arraycopy(parameters, 0, rows[3], 0, 3);
                yield rows;
            }
            case "DIMETRIC" -> dimetric();
            case "ISOMETRIC" -> isometric();
            case "ROTAXIS" -> sevenSteps(parameters);
            default -> matrix.rows(parameters);
        };
    }

    private static double[][] dimetric() {
        return new double[][] {
            {0.935414346693485, 0.133630620956212, -0.327326835353989, 0},
            {0, 0.925820099772551, 0.377964473009227, 0},
            {0.353553390593274, -0.353553390593274, 0.866025403784439, 0},
            {0, 0, 0, 1}
        };
    }

    private static double[][] isometric() {
        return new double[][] {
            {0.707106781186548, 0.408248290463863, -0.577350269189626, 0},
            {0, 0.816496580927726, 0.577350269189626, 0},
            {0.707106781186548, -0.408248290463863, 0.577350269189626, 0},
            {0, 0, 0, 1}
        };
    }

    private static double[][] diagonal(double a, double e, double j, double s) {
        return new double[][] {
            {a, 0, 0, 0},
            {0, e, 0, 0},
            {0, 0, j, 0},
            {0, 0, 0, s}
        };
    }

    /** The images of the origin and of the three axes' ends tell the whole matrix. */
    private static double[][] sevenSteps(double[] p) {
        double[] points = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
        new SevenStepsTextbook()
                .rotate(
                        new double[] {p[0], p[1], p[2]},
                        new double[] {p[3], p[4], p[5]},
                        p[6],
                        points);
        double[][] rows = diagonal(0, 0, 0, 1);
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 3; j++)
                rows[i][j] = points[3 * i + j] - (i < 3 ? points[9 + j] : 0);
        return rows;
    }
}
