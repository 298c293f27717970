package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.shade.FormulaShader;

/**
 * The formula at every point, with the corners' unit normals mixed and brought to length 1 again.
 *
 * <p>Source: B. T. Phong, Illumination for computer generated pictures, Communications of the ACM
 * 18(6), 1975, pp. 311–317.
 */
final class PhongFace implements SteppedFace {
    private final FormulaShader formula;

    PhongFace() {
        this(Reflection.PHONG);
    }

    /** Makes Phong shading with another formula. */
    PhongFace(Reflection reflection) {
        formula = new FormulaShader(reflection);
    }

    @Override
    public double[] shade(LitFace face, double[] weights, Evaluations told) {
        FacePoint.requireWeights(weights);
        var shades = new double[weights.length];
        double[] normals = FacePoint.unit(face.normals());
        for (int i = 0; i < weights.length; i += 3) {
            double a = weights[i];
            double b = weights[i + 1];
            double c = weights[i + 2];
            double[] place = FacePoint.mixed(face.corners(), a, b, c);
            double[] normal = FacePoint.mixed(normals, a, b, c);
            LitPoint point = FacePoint.of(face, place, normal);
            boolean lit = LampSide.isLit(face, weights, i, normal, point.toLight());
            double[] shade = formula.intensity(point, lit);
            told.at(place, normal, shade);
            System.arraycopy(shade, 0, shades, i, 3);
        }
        return shades;
    }
}
