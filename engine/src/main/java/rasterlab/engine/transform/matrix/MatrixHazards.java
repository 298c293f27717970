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
                exact("scale-x", "The one scale that is printed right.", "SCALE3DX", 2),
                misprint("scale-y", "Printed with a 0 for x.", "SCALE3DY", 2),
                misprint("scale-z", "Printed with zeros for x and y.", "SCALE3DZ", 2),
                misprint("scale-all", "Printed with s alone.", "SCALE3D", 2),
                misprint("shift", "Printed without its diagonal.", "TRANSL3D", 1, 2, 3),
                misprint(
                        "dimetric", "The printed cells have the two angles exchanged.", "DIMETRIC"),
                exact("isometric", "The printed cells are right.", "ISOMETRIC"),
                exact(
                        "isometric-by-printed-angles",
                        "The angles beside the isometric cells are the dimetric α and 45°: turned"
                                + " by them the axes are shortened unequally.",
                        "TRIMETRIC",
                        AppendixFormula.ALPHA,
                        45));
    }

    private static List<Hazard<MatrixCall>> steps() {
        return List.of(
                misprint(
                        "axis",
                        "The printed steps move the axis.",
                        "ROTAXIS",
                        0,
                        0,
                        0,
                        1,
                        2,
                        2,
                        37),
                misprint(
                        "axis-along-z",
                        "The printed steps divide 0 by 0.",
                        "ROTAXIS",
                        1,
                        2,
                        3,
                        0,
                        0,
                        1,
                        90));
    }

    private static List<Hazard<MatrixCall>> hard() {
        return List.of(
                exact("about-y", "Seen from its positive end, y turns z towards x.", "ROT3DY", 30),
                exact("right-angle", "cos 90° is 0, not 6·10⁻¹⁷.", "ROT3DX", 90),
                exact("huge-angle", "10¹⁵ turns and 64° in one angle.", "ROT3DZ", 360e15 + 64),
                exact(
                        "look-from-afar",
                        "The eye's distance swallows the difference of the coordinates.",
                        "LOOKAT",
                        1e12,
                        1e12 + 1,
                        -1e12,
                        1e12,
                        1e12,
                        1e12,
                        0,
                        1,
                        0),
                exact(
                        "up-near-the-line-of-sight",
                        "up is 1° off the line of sight, where two digits of a cross product of rounded"
                                + " directions cancel.",
                        "LOOKAT",
                        0,
                        -74,
                        0,
                        67,
                        0,
                        0,
                        37,
                        41,
                        1),
                exact(
                        "narrow-frustum",
                        "far is next to near: the depth's cells are differences of equals.",
                        "GL_FRUSTUM",
                        -1,
                        1,
                        -1,
                        1,
                        1,
                        Math.nextUp(1.0)));
    }

    private static List<Hazard<MatrixCall>> extremes() {
        return List.of(
                exact(
                        "small-pyramid",
                        "a/zmax does not fit in a double, a/zmax/xscreen does: the smallest doubles cancel.",
                        "NORMALIZE",
                        Double.MIN_VALUE,
                        Double.MIN_VALUE,
                        Double.MIN_VALUE,
                        2),
                exact(
                        "box-of-largest-doubles",
                        "top + bottom does not fit in a double, its quotient by top − bottom does.",
                        "GL_ORTHO",
                        0,
                        1,
                        1e308,
                        Double.MAX_VALUE,
                        0,
                        1),
                hazard(
                        "axis-through-largest-doubles",
                        "The shift fits in a double; a sum on the way to it does not.",
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
                        "right − left is so small that 2·near / (right − left) does not fit in a double.",
                        Map.of("formula-textbook", REFUSED, "formula", REFUSED),
                        MatrixCall.of("GL_FRUSTUM", 0, 1e-300, -1, 1, 1e10, 1e11)));
    }

    private static Hazard<MatrixCall> misprint(
            String name, String description, String matrix, double... numbers) {
        return hazard(
                name,
                description,
                Map.of("formula-textbook", WRONG),
                MatrixCall.of(matrix, numbers));
    }

    private static Hazard<MatrixCall> exact(
            String name, String description, String matrix, double... numbers) {
        return hazard(name, description, Map.of(), MatrixCall.of(matrix, numbers));
    }

    private static Hazard<MatrixCall> hazard(
            String name, String description, Map<String, Verdict.Kind> failing, MatrixCall call) {
        return Hazard.allExactBut(failing, MatrixMethods.all(), name, description, call);
    }
}
