package rasterlab.engine.transform.matrix;

import java.util.List;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class MatrixMethods {
    private MatrixMethods() {}

    static List<Method<MatrixFormula>> all() {
        return List.of(
                new Method<>(
                        "formula-textbook",
                        new About(
                                "the cells as the appendix prints them",
                                "none; SCALE3DY, SCALE3DZ, SCALE3D and TRANSL3D flatten space",
                                "at most two sines and cosines; no size to grow with but 3 or 4"
                                        + " rows",
                                "zeros on the diagonal of scales and of the shift; DIMETRIC with"
                                        + " its angles exchanged; ROTAXIS moves its axis",
                                "Ponomarev, course text on computer graphics, appendix"),
                        new AppendixFormula()),
                new Method<>(
                        "formula",
                        new About(
                                "[x y z 1] · [a b c p; d e f q; g i j r; l m n s]",
                                "B · Bᵀ = 1 for turns and reflections",
                                "at most two sines and cosines; no size to grow with but 3 or 4"
                                        + " rows",
                                "none known; refuses cells that are too large for a double",
                                "Ponomarev, course text on computer graphics; Kazantsev, course"
                                        + " text on computer graphics; M. Segal, K. Akeley, The"
                                        + " OpenGL Graphics System, 2003"),
                        new NamedFormula()));
    }
}
