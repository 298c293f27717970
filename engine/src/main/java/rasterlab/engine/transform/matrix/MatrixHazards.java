package rasterlab.engine.transform.matrix;

import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** The appendix's misprints, and parameters for which a formula is hard to get right. */
final class MatrixHazards {
    private MatrixHazards() {}

    static List<Hazard<MatrixCall>> all() {
        return Stream.of(scales(), steps(), hard(), extremes()).flatMap(List::stream).toList();
    }

    private static List<Hazard<MatrixCall>> scales() {
        return List.of(
                exact("scale-x", "SCALE3DX", 2),
                misprint("scale-y", "SCALE3DY", 2),
                misprint("scale-z", "SCALE3DZ", 2),
                misprint("scale-all", "SCALE3D", 2),
                misprint("shift", "TRANSL3D", 1, 2, 3),
                misprint("dimetric", "DIMETRIC"),
                exact("isometric", "ISOMETRIC"),
                exact("isometric-by-printed-angles", "TRIMETRIC", AppendixFormula.ALPHA, 45));
    }

    private static List<Hazard<MatrixCall>> steps() {
        return List.of(
                misprint("axis", "ROTAXIS", 0, 0, 0, 1, 2, 2, 37),
                misprint("axis-along-z", "ROTAXIS", 1, 2, 3, 0, 0, 1, 90));
    }

    private static List<Hazard<MatrixCall>> hard() {
        return List.of(
                exact("about-y", "ROT3DY", 30),
                exact("right-angle", "ROT3DX", 90),
                exact("huge-angle", "ROT3DZ", 360e15 + 64),
                exact("look-from-afar", "LOOKAT", 1e12, 1e12 + 1, -1e12, 1e12, 1e12, 1e12, 0, 1, 0),
                exact("up-near-the-line-of-sight", "LOOKAT", 0, -74, 0, 67, 0, 0, 37, 41, 1),
                exact("narrow-frustum", "GL_FRUSTUM", -1, 1, -1, 1, 1, Math.nextUp(1.0)));
    }

    private static List<Hazard<MatrixCall>> extremes() {
        return List.of(
                exact(
                        "small-pyramid",
                        "NORMALIZE",
                        Double.MIN_VALUE,
                        Double.MIN_VALUE,
                        Double.MIN_VALUE,
                        2),
                exact("box-of-largest-doubles", "GL_ORTHO", 0, 1, 1e308, Double.MAX_VALUE, 0, 1),
                hazard(
                        "axis-through-largest-doubles",
                        Map.of("formula-textbook", REFUSED),
                        MatrixCall.of(
                                "ROTAXIS",
                                Double.MAX_VALUE,
                                Double.MAX_VALUE,
                                0,
                                0,
                                0,
                                1,
                                5.755166896282639E-14)),
                hazard(
                        "frustum-of-nothing",
                        Map.of("formula-textbook", REFUSED, "formula", REFUSED),
                        MatrixCall.of("GL_FRUSTUM", 0, 1e-300, -1, 1, 1e10, 1e11)));
    }

    private static Hazard<MatrixCall> misprint(String name, String matrix, double... numbers) {
        return hazard(name, Map.of("formula-textbook", WRONG), MatrixCall.of(matrix, numbers));
    }

    private static Hazard<MatrixCall> exact(String name, String matrix, double... numbers) {
        return hazard(name, Map.of(), MatrixCall.of(matrix, numbers));
    }

    private static Hazard<MatrixCall> hazard(
            String name, Map<String, Verdict.Kind> failing, MatrixCall call) {
        return Hazard.allExactBut(failing, MatrixMethods.all(), name, call);
    }
}
