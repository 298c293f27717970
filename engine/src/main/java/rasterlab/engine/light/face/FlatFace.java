package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.normals.TriangleNormal;
import rasterlab.engine.light.shade.FormulaShader;

/** The formula once, in the middle of the face, with the face's own normal. */
final class FlatFace implements SteppedFace {
    private static final int[] CORNERS = {0, 1, 2};

    private final FormulaShader formula = new FormulaShader(Reflection.PHONG);
    private final boolean divided;

    /**
     * @param divided whether the normal is taken after the perspective division, as the textbooks
     *     warn
     */
    FlatFace(boolean divided) {
        this.divided = divided;
    }

    @Override
    public double[] shade(LitFace face, double[] weights, Evaluations told) {
        FacePoint.requireWeights(weights);
        double third = 1 / 3.0;
        double[] middle = FacePoint.mixed(face.corners(), third, third, third);
        var normal = new double[3];
        if (divided) DividedNormal.of(face, middle, normal);
        else TriangleNormal.cross(face.corners(), CORNERS, 0, normal);
        double[] shade = formula.intensity(FacePoint.of(face, middle, normal));
        told.at(middle, normal, shade);
        var shades = new double[weights.length];
        for (int i = 0; i < weights.length; i += 3) System.arraycopy(shade, 0, shades, i, 3);
        return shades;
    }
}
