package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.shade.FormulaShader;

/**
 * The formula at the three corners, cut there; between them the three colours are mixed.
 *
 * <p>Source: H. Gouraud, Continuous shading of curved surfaces, IEEE Transactions on Computers
 * 20(6), 1971, pp. 623–629.
 */
final class GouraudFace implements SteppedFace {
    private final FormulaShader formula;

    GouraudFace() {
        this(Reflection.PHONG);
    }

    /** Makes Gouraud shading with another formula. */
    GouraudFace(Reflection reflection) {
        formula = new FormulaShader(reflection);
    }

    @Override
    public double[] shade(LitFace face, double[] weights, Evaluations told) {
        FacePoint.requireWeights(weights);
        var corners = new double[9];
        for (int k = 0; k < 9; k += 3) {
            double[] place = {face.corners()[k], face.corners()[k + 1], face.corners()[k + 2]};
            double[] normal = {face.normals()[k], face.normals()[k + 1], face.normals()[k + 2]};
            double[] shade = formula.intensity(FacePoint.of(face, place, normal));
            told.at(place, normal, shade);
            System.arraycopy(shade, 0, corners, k, 3);
        }
        var shades = new double[weights.length];
        for (int i = 0; i < weights.length; i += 3)
            System.arraycopy(
                    FacePoint.mixed(corners, weights[i], weights[i + 1], weights[i + 2]),
                    0,
                    shades,
                    i,
                    3);
        return shades;
    }
}
