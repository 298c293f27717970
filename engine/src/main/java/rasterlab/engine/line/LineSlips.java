package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.study.Slip;

/** Segments drawn from another place. */
final class LineSlips {
    private LineSlips() {}

    static List<Slip<LineRasterizer>> of(LineRasterizer right) {
        return List.of(
                Slip.of(
                        "drawn-from-the-origin",
                        (x0, y0, x1, y1, out) -> right.draw(0, 0, x1 - x0, y1 - y0, out)),
                Slip.of(
                        "second-end-as-length",
                        (x0, y0, x1, y1, out) -> right.draw(x0, y0, x0 + x1, y0 + y1, out)));
    }
}
