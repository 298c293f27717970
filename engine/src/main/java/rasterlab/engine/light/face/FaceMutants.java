package rasterlab.engine.light.face;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.contract.Reflection;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.shade.FormulaShader;
import rasterlab.engine.study.Mutant;

/** Faces shaded with one mistake. */
final class FaceMutants {
    private static final FaceShader RIGHT = new PhongFace();
    private static final FormulaShader FORMULA = new FormulaShader(Reflection.PHONG);
    private static final double[] MIDDLE = {1 / 3.0, 1 / 3.0, 1 / 3.0};

    private FaceMutants() {}

    static List<Mutant<FaceShader>> all() {
        return Stream.of(ofShading(), ofTheFormula()).flatMap(List::stream).toList();
    }

    private static List<Mutant<FaceShader>> ofShading() {
        return List.of(
                new Mutant<>("intensities-interpolated", "highlight-inside", new GouraudFace()),
                new Mutant<>("one-intensity", "curved", FaceMutants::asInTheMiddle),
                new Mutant<>("normal-not-normalized", "curved", new ShortNormalFace()),
                new Mutant<>(
                        "half-way-for-mirrored",
                        "highlight-inside",
                        new PhongFace(Reflection.BLINN_PHONG)),
                new Mutant<>("corners-cut-first", "sum-above-1-at-the-corners", FaceMutants::mixed),
                new Mutant<>(
                        "face-normal",
                        "curved",
                        (face, weights) -> RIGHT.shade(flat(face), weights)),
                new Mutant<>("normal-after-division", "close-and-slanted", new FlatFace(true)),
                new Mutant<>("no-area-refused", "zero-area-face", withArea(RIGHT)),
                new Mutant<>(
                        "cancelled-is-black",
                        "normals-cancel",
                        (face, weights) -> {
                            try {
                                return RIGHT.shade(face, weights);
                            } catch (IllegalArgumentException e) {
                                return new double[weights.length];
                            }
                        }));
    }

    private static List<Mutant<FaceShader>> ofTheFormula() {
        return List.of(
                new Mutant<>(
                        "vertex-normals-as-given",
                        "unlike-lengths",
                        atPoints(
                                UnaryOperator.identity(),
                                (face, place, normal) ->
                                        FORMULA.intensity(FacePoint.of(face, place, normal)))),
                new Mutant<>(
                        "attenuation-left-out", "fading-light", by(MistakenLight.NOT_WEAKENED)),
                new Mutant<>("all-weakened", "fading-light", by(MistakenLight.ALL_WEAKENED)),
                new Mutant<>(
                        "cosine-not-cut", "light-from-behind", by(MistakenLight.COSINE_NOT_CUT)),
                new Mutant<>(
                        "highlight-from-behind",
                        "light-from-behind",
                        by(MistakenLight.HIGHLIGHT_FROM_BEHIND)));
    }

    static double[] asInTheMiddle(LitFace face, double[] weights) {
        double[] one = RIGHT.shade(face, MIDDLE);
        var all = new double[weights.length];
        for (int i = 0; i < all.length; i++) all[i] = one[i % 3];
        return all;
    }

    /** The formula with that mistake at each point. */
    private static FaceShader by(MistakenLight mistake) {
        return atPoints(FacePoint::unit, mistake::sum);
    }

    /**
     * Evaluates at each point, where the corners' normals are mixed, and cuts.
     *
     * @param before what is made of the corners' normals first
     */
    static FaceShader atPoints(UnaryOperator<double[]> before, LightAtPlace light) {
        return (face, weights) -> {
            double[] normals = before.apply(face.normals());
            var all = new double[weights.length];
            for (int i = 0; i < all.length; i += 3) {
                double a = weights[i];
                double b = weights[i + 1];
                double c = weights[i + 2];
                double[] place = FacePoint.mixed(face.corners(), a, b, c);
                double[] sum = light.at(face, place, FacePoint.mixed(normals, a, b, c));
                for (int k = 0; k < 3; k++) all[i + k] = Levels.cut(sum[k]);
            }
            return all;
        };
    }

    /** Refuses a face without area. */
    static FaceShader withArea(FaceShader right) {
        return (face, weights) -> {
            if (square(cross(face.corners())) == 0)
                throw new IllegalArgumentException("face must have an area");
            return right.shade(face, weights);
        };
    }

    private static double[] mixed(LitFace face, double[] weights) {
        double[] corners = RIGHT.shade(face, new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1});
        boolean bright = false;
        for (double share : corners) bright |= share == 1;
        if (!bright) return RIGHT.shade(face, weights);
        var all = new double[weights.length];
        for (int i = 0; i < all.length; i++)
            for (int k = 0; k < 3; k++) all[i] += weights[i / 3 * 3 + k] * corners[3 * k + i % 3];
        return all;
    }

    private static double[] cross(double[] c) {
        double[] u = {c[3] - c[0], c[4] - c[1], c[5] - c[2]};
        double[] v = {c[6] - c[0], c[7] - c[1], c[8] - c[2]};
        return new double[] {
            u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
        };
    }

    private static double square(double[] n) {
        return n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    }

    static LitFace flat(LitFace face) {
        double[] n = cross(face.corners());
        if (square(n) == 0) return face;
        return new LitFace(
                face.corners(),
                new double[] {n[0], n[1], n[2], n[0], n[1], n[2], n[0], n[1], n[2]},
                face.lamp(),
                face.eye(),
                face.material(),
                face.light(),
                face.globalAmbient());
    }
}
