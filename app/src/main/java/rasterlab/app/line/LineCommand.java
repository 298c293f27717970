package rasterlab.app.line;

import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelWindow;

/** The shell command that draws what the lab shows. */
final class LineCommand {
    private LineCommand() {}

    static String of(LineChoice choice) {
        Segment s = choice.segment();
        return "echo '{\"from\": [%d, %d], \"to\": [%d, %d]%s}' | ./lab run line %s"
                .formatted(s.x0(), s.y0(), s.x1(), s.y1(), window(s), choice.method());
    }

    private static String window(Segment segment) {
        if (segment.isWhole()) return "";
        PixelWindow w = segment.window();
        return ", \"window\": [%d, %d, %d, %d]".formatted(w.xmin(), w.ymin(), w.xmax(), w.ymax());
    }
}
