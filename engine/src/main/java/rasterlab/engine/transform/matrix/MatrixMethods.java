package rasterlab.engine.transform.matrix;

import java.util.List;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class MatrixMethods {
    private MatrixMethods() {}

    static List<Method<MatrixFormula>> all() {
        return List.of(
                Method.failing("formula-textbook", new AppendixFormula()),
                Method.right("formula", new NamedFormula()));
    }
}
