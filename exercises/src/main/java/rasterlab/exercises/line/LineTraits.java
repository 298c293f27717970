package rasterlab.exercises.line;

import java.util.LinkedHashSet;
import java.util.Set;
import rasterlab.engine.line.Segment;

/** Traits that distinguish segments, for a method that goes wrong on some of them. */
final class LineTraits {
    /** A coordinate beyond it is far: there a float has no place for halves any more. */
    private static final int FAR = 1 << 22;

    private LineTraits() {}

    static Set<String> of(Segment s) {
        long dx = (long) s.x1() - s.x0();
        long dy = (long) s.y1() - s.y0();
        Set<String> traits = new LinkedHashSet<>();
        if (dx == 0 && dy == 0) traits.add("point");
        else if (dy == 0) traits.add("horizontal");
        else if (dx == 0) traits.add("vertical");
        else if (Math.abs(dx) == Math.abs(dy)) traits.add("diagonal");
        else traits.add(Math.abs(dy) > Math.abs(dx) ? "steep" : "gentle");
        if (dx != 0) traits.add(dx > 0 ? "right" : "left");
        if (dy != 0) traits.add(dy > 0 ? "down" : "up");
        if (isFar(s.x0()) || isFar(s.y0()) || isFar(s.x1()) || isFar(s.y1())) traits.add("far");
        return traits;
    }

    private static boolean isFar(int coordinate) {
        return coordinate > FAR || coordinate < -FAR;
    }
}
