package rasterlab.engine.light.face;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.contract.Reflection;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.shade.FormulaShader;
import rasterlab.engine.study.Mutant;

/** Gouraud's shading with one mistake, where just that shading is asked for. */
final class GouraudMutants {
    private static final FaceShader RIGHT = new GouraudFace();
    private static final FormulaShader FORMULA = new FormulaShader(Reflection.PHONG);
    private static final double[] CORNERS = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    private GouraudMutants() {}

    static List<Mutant<FaceShader>> all() {
        return Stream.of(elsewhere(), ofTheFormula(), ofMixing()).flatMap(List::stream).toList();
    }

    /** The formula is evaluated somewhere else than at the corners. */
    private static List<Mutant<FaceShader>> elsewhere() {
        return List.of(
                new Mutant<>("normals-interpolated", "highlight-inside", new PhongFace()),
                new Mutant<>("one-intensity", "curved", FaceMutants::asInTheMiddle),
                new Mutant<>("face-normal-in-the-middle", "curved", new FlatFace(false)),
                new Mutant<>("first-vertex-alone", "fading-light", everywhere(1, 0, 0)),
                new Mutant<>(
                        "mean-of-the-vertices",
                        "fading-light",
                        everywhere(1 / 3.0, 1 / 3.0, 1 / 3.0)),
                new Mutant<>(
                        "face-normal",
                        "curved",
                        (face, weights) -> RIGHT.shade(FaceMutants.flat(face), weights)),
                new Mutant<>(
                        "directions-from-the-middle",
                        "fading-light",
                        cut(
                                (face, place, normal) ->
                                        FORMULA.intensity(
                                                FacePoint.of(face, middle(face), normal)))));
    }

    private static List<Mutant<FaceShader>> ofTheFormula() {
        return List.of(
                new Mutant<>(
                        "vertex-normals-as-given",
                        "unlike-lengths",
                        cut(MistakenLight.NORMAL_AS_GIVEN::sum)),
                new Mutant<>(
                        "attenuation-left-out",
                        "fading-light",
                        cut(MistakenLight.NOT_WEAKENED::sum)),
                new Mutant<>("all-weakened", "fading-light", cut(MistakenLight.ALL_WEAKENED::sum)),
                new Mutant<>(
                        "cosine-not-cut",
                        "light-from-behind",
                        cut(MistakenLight.COSINE_NOT_CUT::sum)),
                new Mutant<>(
                        "highlight-from-behind",
                        "light-from-behind",
                        cut(MistakenLight.HIGHLIGHT_FROM_BEHIND::sum)),
                new Mutant<>(
                        "half-way-for-mirrored",
                        "fading-light",
                        new GouraudFace(Reflection.BLINN_PHONG)));
    }

    private static List<Mutant<FaceShader>> ofMixing() {
        return List.of(
                new Mutant<>(
                        "cut-after-mixing",
                        "sum-above-1-at-the-corners",
                        (face, weights) -> {
                            double[] mixed = mixed(uncut(face), weights);
                            for (int i = 0; i < mixed.length; i++) mixed[i] = Levels.cut(mixed[i]);
                            return mixed;
                        }),
                new Mutant<>(
                        "colour-for-vertex",
                        "fading-light",
                        (face, weights) -> mixed(turned(RIGHT.shade(face, CORNERS)), weights)),
                new Mutant<>("no-area-refused", "zero-area-face", FaceMutants.withArea(RIGHT)));
    }

    /** Cuts the light of each corner, then mixes. */
    static FaceShader cut(LightAtPlace light) {
        return (face, weights) -> {
            double[] corners = corners(face, light);
            for (int i = 0; i < 9; i++) corners[i] = Levels.cut(corners[i]);
            return mixed(corners, weights);
        };
    }

    private static double[] uncut(LitFace face) {
        return corners(
                face, (of, place, normal) -> FORMULA.terms(FacePoint.of(of, place, normal)).sum());
    }

    private static double[] corners(LitFace face, LightAtPlace light) {
        var corners = new double[9];
        for (int k = 0; k < 9; k += 3) {
            double[] place = {face.corners()[k], face.corners()[k + 1], face.corners()[k + 2]};
            double[] normal = {face.normals()[k], face.normals()[k + 1], face.normals()[k + 2]};
            System.arraycopy(light.at(face, place, normal), 0, corners, k, 3);
        }
        return corners;
    }

    private static double[] mixed(double[] corners, double[] weights) {
        var all = new double[weights.length];
        for (int i = 0; i < all.length; i += 3)
            System.arraycopy(
                    FacePoint.mixed(corners, weights[i], weights[i + 1], weights[i + 2]),
                    0,
                    all,
                    i,
                    3);
        return all;
    }

    /** One mixture of the corners' intensities at every point. */
    private static FaceShader everywhere(double a, double b, double c) {
        return (face, weights) -> {
            var same = weights.clone();
            for (int i = 0; i < same.length; i += 3)
                System.arraycopy(new double[] {a, b, c}, 0, same, i, 3);
            return RIGHT.shade(face, same);
        };
    }

    private static double[] middle(LitFace face) {
        return FacePoint.mixed(face.corners(), 1 / 3.0, 1 / 3.0, 1 / 3.0);
    }

    /** Rows for columns of three times three numbers. */
    private static double[] turned(double[] nine) {
        var turned = new double[9];
        for (int i = 0; i < 9; i++) turned[i] = nine[i % 3 * 3 + i / 3];
        return turned;
    }
}
