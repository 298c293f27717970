package rasterlab.engine.transform.matrix;

import static rasterlab.engine.study.Verdict.Kind.EXACT;
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
        return Stream.of(scales(), steps(), hard()).flatMap(List::stream).toList();
    }

    private static List<Hazard<MatrixCall>> scales() {
        return List.of(
                hazard(
                        "scale-x",
                        "The one scale that is printed right.",
                        EXACT,
                        EXACT,
                        "SCALE3DX",
                        2),
                hazard("scale-y", "Printed with a 0 for x.", WRONG, EXACT, "SCALE3DY", 2),
                hazard("scale-z", "Printed with zeros for x and y.", WRONG, EXACT, "SCALE3DZ", 2),
                hazard("scale-all", "Printed with s alone.", WRONG, EXACT, "SCALE3D", 2),
                hazard("shift", "Printed without its diagonal.", WRONG, EXACT, "TRANSL3D", 1, 2, 3),
                hazard(
                        "dimetric",
                        "The printed cells have the two angles exchanged.",
                        WRONG,
                        EXACT,
                        "DIMETRIC"),
                hazard(
                        "isometric",
                        "The angles printed are not isometric.",
                        WRONG,
                        EXACT,
                        "ISOMETRIC"));
    }

    private static List<Hazard<MatrixCall>> steps() {
        return List.of(
                hazard(
                        "axis",
                        "The printed steps move the axis.",
                        WRONG,
                        EXACT,
                        "ROTAXIS",
                        0,
                        0,
                        0,
                        1,
                        2,
                        2,
                        37),
                hazard(
                        "axis-along-z",
                        "The printed steps divide 0 by 0.",
                        WRONG,
                        EXACT,
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
                hazard("right-angle", "cos 90° is 0, not 6·10⁻¹⁷.", EXACT, EXACT, "ROT3DX", 90),
                hazard("huge-angle", "10¹⁵ turns and 30°.", EXACT, EXACT, "ROT3DZ", 360e15 + 64),
                hazard(
                        "look-from-afar",
                        "The eye's distance swallows the difference of the coordinates.",
                        EXACT,
                        EXACT,
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
                hazard(
                        "narrow-frustum",
                        "far is next to near: the depth's cells are differences of equals.",
                        EXACT,
                        EXACT,
                        "GL_FRUSTUM",
                        -1,
                        1,
                        -1,
                        1,
                        1,
                        Math.nextUp(1.0)),
                hazard(
                        "frustum-of-nothing",
                        "right − left is so small that 2·near / (right − left) is no double.",
                        REFUSED,
                        REFUSED,
                        "GL_FRUSTUM",
                        0,
                        1e-300,
                        -1,
                        1,
                        1e10,
                        1e11));
    }

    private static Hazard<MatrixCall> hazard(
            String name,
            String description,
            Verdict.Kind textbook,
            Verdict.Kind formula,
            String matrix,
            double... numbers) {
        return new Hazard<>(
                name,
                description,
                MatrixCall.of(matrix, numbers),
                Map.of("formula-textbook", textbook, "formula", formula));
    }
}
