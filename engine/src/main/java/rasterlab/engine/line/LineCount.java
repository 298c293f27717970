package rasterlab.engine.line;

import java.util.Map;

/**
 * The operations of a method on its way along one segment: its work at a step, times the steps that
 * it made.
 */
record LineCount(LineWork work, long pixels, long across) {
    static LineCount of(SteppedLine method, Segment segment) {
        LineWalk walk = LineTopic.walk(method, segment);
        long pixels = 0;
        long across = 0;
        int x = 0;
        int y = 0;
        while (walk.advance()) {
            if (pixels > 0 && walk.x() != x && walk.y() != y) across++;
            x = walk.x();
            y = walk.y();
            pixels++;
        }
        return new LineCount(method.work(), pixels, across);
    }

    void addTo(Map<String, Long> counts) {
        work.start().addTo(counts, 1);
        work.pixel().addTo(counts, pixels);
        work.across().addTo(counts, across);
    }
}
