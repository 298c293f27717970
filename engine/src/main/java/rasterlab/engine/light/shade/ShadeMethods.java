package rasterlab.engine.light.shade;

import java.util.List;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class ShadeMethods {

    private ShadeMethods() {}

    static List<Method<PointShader>> all() {
        return List.of(
                Method.right("lambert", new FormulaShader(Reflection.LAMBERT)),
                Method.failing("phong-textbook", new PrintedShader()),
                Method.right("phong", new FormulaShader(Reflection.PHONG)),
                Method.failing("blinn-phong", new FormulaShader(Reflection.BLINN_PHONG)));
    }
}
