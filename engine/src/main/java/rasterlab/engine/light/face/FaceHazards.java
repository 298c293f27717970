package rasterlab.engine.light.face;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Faces on which saving work shows. */
final class FaceHazards {
    private static final double[] ABOVE = {0, 0, 5};
    private static final double[] FAR = {0, 0, 1e6};
    private static final int ROWS = 6;

    private FaceHazards() {}

    static List<Hazard<FacePoints>> all() {
        return Stream.of(curved(), sideHazards(), degenerate(), ofTheFormula())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<FacePoints>> curved() {
        double[] tilted = {0, 0, 0, 4, 0, 3, 0, 3, 0};
        double[] across = {-9, 0, 12, -9, 0, 12, -9, 0, 12};
        return List.of(
                hazard(
                        "dull-and-flat",
                        FaceSamples.face(
                                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
                                new double[] {0, 0, 1, 0, 0, 1, 0, 0, 1},
                                FAR,
                                FAR,
                                FaceSamples.gray(0.5, 0, 0)),
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "highlight-inside",
                        FaceSamples.dome(0.5, ABOVE, ABOVE, FaceSamples.gray(0.4, 0.5, 60)),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG),
                hazard(
                        "curved",
                        FaceSamples.dome(0.6, FAR, FAR, FaceSamples.gray(0.8, 0, 0)),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG),
                hazard(
                        "sum-above-1-at-the-corners",
                        FaceSamples.face(
                                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
                                new double[] {0, 0, 1, 1, 0, 0.2, 0, 1, 0.2},
                                FAR,
                                FAR,
                                FaceSamples.gray(1, 0.5, 1)),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG),
                hazard(
                        "close-and-slanted",
                        FaceSamples.face(tilted, across, FAR, ABOVE, FaceSamples.gray(0.6, 0, 0)),
                        WRONG,
                        DEGRADED,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<FacePoints>> sideHazards() {
        return List.of(
                hazard(
                        "lamp-in-the-plane",
                        FaceSamples.face(
                                new double[] {0, 0, 0, 5, 0, -6, 0, 5, -8},
                                new double[] {6, 8, 5, 6, 8, 5, 12, 16, 10},
                                new double[] {-5, 10, -10},
                                new double[] {11, 3, 7},
                                FaceSamples.gray(0.5, 0.5, 1)),
                        WRONG,
                        WRONG,
                        EXACT,
                        WRONG));
    }

    private static List<Hazard<FacePoints>> degenerate() {
        double[] up = {0, 0, 1, 0, 0, 1, 0, 0, 1};
        return List.of(
                hazard(
                        "zero-area-face",
                        FaceSamples.face(
                                new double[] {0, 0, 0, 1, 0, 0, 2, 0, 0},
                                up,
                                FAR,
                                FAR,
                                FaceSamples.gray(0.5, 0, 0)),
                        REFUSED,
                        REFUSED,
                        EXACT,
                        EXACT),
                new Hazard<>(
                        "normals-cancel",
                        new FacePoints(
                                FaceSamples.face(
                                        new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
                                        new double[] {1, 0, 0, -1, 0, 0, 0, 0, 1},
                                        ABOVE,
                                        ABOVE,
                                        FaceSamples.gray(0.5, 0, 0)),
                                new double[] {0.5, 0.5, 0}),
                        recorded(WRONG, WRONG, WRONG, WRONG, REFUSED)));
    }

    /** Where a term of the formula is easily forgotten. */
    private static List<Hazard<FacePoints>> ofTheFormula() {
        double[] corners = {-2, -1, 0, 2, -1, 0.5, 0, 2, -0.5};
        double[] normals = {-0.3, -0.2, 1, 0.4, -0.1, 1, 0, 0.5, 1};
        double[] behind = {6, 1, -0.5};
        return List.of(
                hazard(
                        "fading-light",
                        new LitFace(
                                corners,
                                normals,
                                new double[] {1, 1, 3},
                                new double[] {-1, 0, 6},
                                FaceSamples.gray(0.5, 0.4, 8),
                                LightSource.white().attenuated(new Attenuation(1, 0.2, 0.05)),
                                new double[] {0.4, 0.4, 0.4}),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG),
                hazard(
                        "light-from-behind",
                        FaceSamples.face(
                                corners,
                                normals,
                                behind,
                                new double[] {-6, -1, 2},
                                FaceSamples.gray(0.5, 0.6, 2)),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG),
                hazard(
                        "unlike-lengths",
                        FaceSamples.face(
                                corners,
                                new double[] {-0.1, 0, 0.3, 1, 0.2, 3, 0, 0.5, 0.8},
                                FAR,
                                ABOVE,
                                FaceSamples.gray(0.6, 0, 0)),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG));
    }

    private static Hazard<FacePoints> hazard(
            String name,
            LitFace face,
            Verdict.Kind flatTextbook,
            Verdict.Kind flat,
            Verdict.Kind gouraud,
            Verdict.Kind phongTextbook) {
        return new Hazard<>(
                name,
                FacePoints.grid(face, ROWS),
                recorded(flatTextbook, flat, gouraud, phongTextbook, EXACT));
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind flatTextbook,
            Verdict.Kind flat,
            Verdict.Kind gouraud,
            Verdict.Kind phongTextbook,
            Verdict.Kind phong) {
        return Map.of(
                "flat-textbook",
                flatTextbook,
                "flat",
                flat,
                "gouraud",
                gouraud,
                "phong-textbook",
                phongTextbook,
                "phong",
                phong);
    }
}
