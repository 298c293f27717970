package rasterlab.engine.transform.matrix;

import rasterlab.contract.MatrixFormula;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.ProjectionMatrices;
import rasterlab.engine.transform.axis.SevenStepsTextbook;

/**
 * The matrices as the course's appendix prints them, misprints included; those that it prints right
 * or not at all come from the right formula.
 *
 * <p>SCALE3DY, SCALE3DZ, SCALE3D and TRANSL3D have zeros on the diagonal where ones belong, so that
 * they flatten space; DIMETRIC has its two angles exchanged; ISOMETRIC is built from the angles
 * printed beside it, which are the dimetric α and 45°; ROTAXIS follows the seven steps, whose
 * second takes sine for cosine.
 *
 * <p>Source: Ponomarev, course text on computer graphics, appendix and "rotation about a line".
 */
public final class AppendixFormula implements MatrixFormula {
    private static final double ALPHA = 22.207654298596487;
    private static final double BETA = 20.70481105463543;

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
            case "DIMETRIC" -> byAngles(BETA, ALPHA);
            case "ISOMETRIC" -> byAngles(ALPHA, 45);
            case "ROTAXIS" -> sevenSteps(parameters);
            default -> matrix.rows(parameters);
        };
    }

    private static double[][] diagonal(double a, double e, double j, double s) {
        return new double[][] {{a, 0, 0, 0}, {0, e, 0, 0}, {0, 0, j, 0}, {0, 0, 0, s}};
    }

    private static double[][] byAngles(double alpha, double beta) {
        double[] cells =
                ProjectionMatrices.trimetric(Angle.ofDegrees(alpha), Angle.ofDegrees(beta))
                        .get(new double[16]);
        var rows = new double[4][4];
        for (int i = 0; i < 16; i++) rows[i / 4][i % 4] = cells[i];
        return rows;
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
