package rasterlab.engine.color;

import java.util.List;
import rasterlab.contract.ColorConverter;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class ColorMethods {

    private ColorMethods() {}

    static List<Method<ColorConverter>> all() {
        return List.of(
                Method.failing("formula-textbook", new CarelessColors()),
                Method.failing("eight-bit", new ByteColors()),
                Method.right("formula", new FormulaColors()));
    }
}
