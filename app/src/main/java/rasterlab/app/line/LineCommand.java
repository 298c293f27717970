package rasterlab.app.line;

import rasterlab.engine.line.Segment;

/** The shell command that draws what the lab shows. */
final class LineCommand {
    private LineCommand() {}

    static String of(LineChoice choice) {
        Segment s = choice.segment();
        return "echo '{\"from\": [%d, %d], \"to\": [%d, %d]}' | ./lab run line %s"
                .formatted(s.x0(), s.y0(), s.x1(), s.y1(), choice.method());
    }
}
