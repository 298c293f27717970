package rasterlab.engine.light.face;

import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.shade.FormulaShader;

/**
 * How far a method's shading of a faceted sphere is from that of the sphere itself, in levels of a
 * picture, over the points that see both lamp and eye.
 *
 * @param worst the largest difference
 * @param mean the mean difference
 * @param points how many were compared
 */
public record SphereError(double worst, double mean, int points) {
    private static final double[] LAMP = {3, 2, 6};
    private static final double[] EYE = {0, 0, 8};
    private static final int ROWS = 6;

    /**
     * Measures a method on a sphere of radius 1.
     *
     * @param meridians of the faceted sphere, at least 3
     * @param parallels of the faceted sphere, at least 2
     */
    public static SphereError of(
            FaceShader method, int meridians, int parallels, SurfaceMaterial material) {
        double worst = 0;
        double sum = 0;
        int points = 0;
        for (int row = 0; row < parallels; row++)
            for (int column = 0; column < meridians; column++)
                for (int half = 0; half < 2; half++) {
                    double[] corners = corners(row, column, half, meridians, parallels);
                    if (corners.length == 0) continue;
                    var face = FaceSamples.face(corners, corners, LAMP, EYE, material);
                    double[] weights = FacePoints.grid(face, ROWS).weights();
                    double[] shades = method.shade(face, weights);
                    for (int i = 0; i < shades.length; i += 3) {
                        double error = error(face, weights, shades, i);
                        if (Double.isNaN(error)) continue;
                        worst = Math.max(worst, error);
                        sum += error;
                        points++;
                    }
                }
        return new SphereError(worst, sum / points, points);
    }

    /** The green channel's error; NaN where the sphere does not see the lamp or the eye. */
    private static double error(LitFace face, double[] weights, double[] shades, int i) {
        double[] point =
                FacePoint.mixed(face.corners(), weights[i], weights[i + 1], weights[i + 2]);
        UnitVector.normalize(point);
        LitPoint lit = FacePoint.of(face, point, point);
        if (dot(point, lit.toLight()) <= 0 || dot(point, lit.toEye()) <= 0) return Double.NaN;
        double right = new FormulaShader(Reflection.PHONG).intensity(lit)[1];
        return Math.abs(shades[i + 1] - right) * Levels.HIGHEST;
    }

    /** Three corners of a half quad, empty where the pole leaves no face. */
    private static double[] corners(int row, int column, int half, int meridians, int parallels) {
        if (half == 0 && row == 0 || half == 1 && row == parallels - 1) return new double[0];
        int[][] at =
                half == 0
                        ? new int[][] {{row, column}, {row, column + 1}, {row + 1, column + 1}}
                        : new int[][] {{row, column}, {row + 1, column + 1}, {row + 1, column}};
        var corners = new double[9];
        for (int k = 0; k < 3; k++) {
            double up = Math.PI * at[k][0] / parallels;
            double around = 2 * Math.PI * at[k][1] / meridians;
            corners[3 * k] = Math.sin(up) * Math.cos(around);
            corners[3 * k + 1] = Math.sin(up) * Math.sin(around);
            corners[3 * k + 2] = -Math.cos(up);
        }
        return corners;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
