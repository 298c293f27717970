package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.study.Method;

/** The methods that draw a segment, in teaching order; each is a {@link SteppedLine}. */
final class LineMethods {

    private LineMethods() {}

    static List<Method<LineRasterizer>> all() {
        return List.of(
                Method.failing("naive-textbook", new NaiveTextbookLine()),
                Method.right("naive", new NaiveLine()),
                Method.failing("dda-float", new FloatDdaLine()),
                Method.right("dda", new DdaLine()),
                Method.failing("bresenham-first-textbook", new BresenhamFirstTextbookLine()),
                Method.failing("bresenham-pascal-textbook", new BresenhamPascalTextbookLine()),
                Method.failing("bresenham-textbook", new BresenhamTextbookLine()),
                Method.right("bresenham", new BresenhamLine()),
                Method.right("midpoint", new MidpointLine()),
                Method.failing("clip-first-textbook", new ClipFirstTextbookLine()),
                Method.right("wu", new WuLine()));
    }
}
