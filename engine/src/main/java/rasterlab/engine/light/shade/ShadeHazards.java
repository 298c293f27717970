package rasterlab.engine.light.shade;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Points for which a printed formula has no right answer. */
final class ShadeHazards {
    private static final double[] UP = {0, 0, 1};
    private static final double[] SLANTED = {0.6, 0, 0.8};
    private static final double[] BELOW = {0.6, 0, -0.8};
    private static final SurfaceMaterial DIM = material(0.1, 0.5, 0.3, 10);

    private ShadeHazards() {}

    static List<Hazard<LitPoints>> all() {
        return Stream.of(signs(), eyes(), lengths(), sums(), lights())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<LitPoints>> signs() {
        return List.of(
                hazard("facing", EXACT, EXACT, lit(UP, SLANTED, UP)),
                hazard("light-behind", WRONG, EXACT, lit(UP, BELOW, UP)),
                hazard(
                        "lit-by-the-smallest-double",
                        EXACT,
                        EXACT,
                        lit(UP, new double[] {4, 0, Double.MIN_VALUE}, UP, material(0, 0, 0.5, 0))),
                hazard(
                        "light-in-the-plane",
                        WRONG,
                        EXACT,
                        lit(
                                new double[] {9, 5, 5},
                                new double[] {5, 0, -9},
                                new double[] {-1, 0, 1})),
                hazard(
                        "light-behind-beside-ambient",
                        WRONG,
                        EXACT,
                        new LitPoint(
                                UP,
                                BELOW,
                                UP,
                                1,
                                DIM,
                                withAmbient(Attenuation.none()),
                                gray(0.5))));
    }

    private static List<Hazard<LitPoints>> eyes() {
        return List.of(
                hazard(
                        "eye-against-the-mirror",
                        WRONG,
                        EXACT,
                        lit(UP, SLANTED, new double[] {0.96, 0, 0.28}, material(0.1, 0.5, 0.3, 2))),
                hazard(
                        "eye-across-the-mirror",
                        WRONG,
                        EXACT,
                        lit(
                                new double[] {3, 0, 2},
                                new double[] {1, 0, 0},
                                new double[] {12, 0, -5},
                                material(0, 0, 0.5, 0.01))),
                hazard(
                        "mirrored-light-a-hair-this-side",
                        WRONG,
                        EXACT,
                        lit(
                                new double[] {0, 1, 1},
                                new double[] {0, 1, 0},
                                new double[] {0, -1e300, 1},
                                material(0, 0, 0.5, 0.001))),
                hazard(
                        "eye-opposite-the-light",
                        DEGRADED,
                        EXACT,
                        lit(UP, SLANTED, new double[] {-0.6, 0, -0.8})),
                hazard("grazing", EXACT, EXACT, lit(UP, new double[] {1, 0, 1e-17}, UP)));
    }

    private static List<Hazard<LitPoints>> lengths() {
        return List.of(
                hazard(
                        "interpolated-normal",
                        WRONG,
                        EXACT,
                        lit(new double[] {0.5, 0, 0.5}, SLANTED, UP)),
                hazard("zero-area-face", WRONG, REFUSED, lit(new double[3], SLANTED, UP)),
                hazard(
                        "huge-normal",
                        WRONG,
                        EXACT,
                        lit(new double[] {3e200, 0, 4e200}, SLANTED, UP)),
                hazard(
                        "tiny-normal",
                        WRONG,
                        EXACT,
                        lit(new double[] {3e-200, 0, 4e-200}, SLANTED, UP)));
    }

    private static List<Hazard<LitPoints>> sums() {
        return List.of(
                hazard("sum-above-1", WRONG, EXACT, lit(UP, UP, UP, material(0.5, 0.9, 0.9, 10))),
                hazard(
                        "sharp-highlight",
                        EXACT,
                        EXACT,
                        lit(
                                UP,
                                SLANTED,
                                new double[] {-0.6, 0, 0.8},
                                material(0.1, 0.2, 0.6, 200))));
    }

    private static List<Hazard<LitPoints>> lights() {
        LightSource square = LightSource.white().attenuated(new Attenuation(0, 0, 1));
        LightSource spot = LightSource.white().through(new SpotCone(BELOW, 20, 8));
        return List.of(
                hazard(
                        "light-in-the-point",
                        WRONG,
                        REFUSED,
                        new LitPoint(UP, SLANTED, UP, 0, DIM, square, new double[3])),
                hazard(
                        "global-ambient-and-distance",
                        EXACT,
                        EXACT,
                        new LitPoint(
                                UP,
                                SLANTED,
                                UP,
                                3,
                                DIM,
                                LightSource.white().attenuated(new Attenuation(1, 0, 1)),
                                gray(0.8))),
                hazard(
                        "own-ambient-and-distance",
                        WRONG,
                        EXACT,
                        new LitPoint(
                                UP,
                                SLANTED,
                                UP,
                                3,
                                DIM,
                                withAmbient(new Attenuation(1, 0, 1)),
                                gray(0))),
                hazard(
                        "outside-the-cone",
                        WRONG,
                        EXACT,
                        new LitPoint(UP, SLANTED, UP, 1, DIM, spot, new double[3])));
    }

    private static LightSource withAmbient(Attenuation attenuation) {
        return new LightSource(gray(0.7), gray(1), gray(1), attenuation, SpotCone.none());
    }

    private static LitPoint lit(double[] normal, double[] toLight, double[] toEye) {
        return lit(normal, toLight, toEye, DIM);
    }

    private static LitPoint lit(
            double[] normal, double[] toLight, double[] toEye, SurfaceMaterial material) {
        return new LitPoint(
                normal, toLight, toEye, 1, material, LightSource.white(), new double[3]);
    }

    private static SurfaceMaterial material(
            double ambient, double diffuse, double specular, double shininess) {
        return new SurfaceMaterial(
                gray(ambient), gray(diffuse), gray(specular), gray(0), shininess);
    }

    private static double[] gray(double share) {
        return new double[] {share, share, share};
    }

    private static Hazard<LitPoints> hazard(
            String name, Verdict.Kind printed, Verdict.Kind right, LitPoint point) {
        return new Hazard<>(
                name,
                new LitPoints(List.of(point)),
                Map.of(
                        "lambert",
                        right,
                        "phong-textbook",
                        printed,
                        "phong",
                        right,
                        "blinn-phong",
                        right));
    }
}
