package rasterlab.engine.fill;

import java.util.List;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.study.Method;

/** The methods that fill a region, in teaching order. */
final class FillMethods {

    private FillMethods() {}

    static List<Method<SeedFiller>> all() {
        return List.of(
                Method.failing("recursive-textbook", new RecursiveTextbookFill()),
                Method.right("stack", new StackFill()),
                Method.right("span", new SpanFill()));
    }
}
