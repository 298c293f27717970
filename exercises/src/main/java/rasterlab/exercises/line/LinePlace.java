package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.score.Cause;

/**
 * Where a line lies that is right but for its place.
 *
 * @param cause why it lies there; nothing where it lies right
 * @param back brings a pixel to where it should be
 */
record LinePlace(Optional<Cause> cause, Motion back) {
    /** Moves a pixel; beyond the range of int it wraps, which then fits no line. */
    interface Motion {
        long[] of(long x, long y);
    }

    /** The places that can be told by the first pixel, the right one first. */
    static List<LinePlace> of(Segment s, PixelRecording actual) {
        List<LinePlace> places = new ArrayList<>();
        places.add(new LinePlace(Optional.empty(), (x, y) -> new long[] {x, y}));
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) if (dx != 0 || dy != 0) places.add(shifted(dx, dy));
        places.add(
                new LinePlace(
                        Optional.of(Cause.of("mirrored-left-right")),
                        (x, y) -> new long[] {2L * s.x0() - x, y}));
        places.add(
                new LinePlace(
                        Optional.of(Cause.of("mirrored-up-down")),
                        (x, y) -> new long[] {x, 2L * s.y0() - y}));
        places.add(
                new LinePlace(
                        Optional.of(Cause.of("mirrored-left-right")),
                        (x, y) -> new long[] {-x, y}));
        places.add(
                new LinePlace(
                        Optional.of(Cause.of("mirrored-up-down")), (x, y) -> new long[] {x, -y}));
        places.add(
                new LinePlace(Optional.of(Cause.of("swapped-axes")), (x, y) -> new long[] {y, x}));
        places.add(
                new LinePlace(
                        Optional.of(Cause.of("swapped-axes")),
                        (x, y) -> new long[] {s.x0() + (y - s.y0()), s.y0() + (x - s.x0())}));
        return places.stream().filter(place -> place.meetsAnEnd(s, actual)).toList();
    }

    private static LinePlace shifted(int dx, int dy) {
        return new LinePlace(
                Optional.of(Cause.of("shifted", signed(dx), signed(dy))),
                (x, y) -> new long[] {x - dx, y - dy});
    }

    private static String signed(int distance) {
        return distance > 0 ? "+" + distance : String.valueOf(distance);
    }

    /** Whether the first pixel is brought to an end or beside one: all others are not tried. */
    private boolean meetsAnEnd(Segment s, PixelRecording actual) {
        long[] first = back.of(actual.x(0), actual.y(0));
        return near(first, s.x0(), s.y0()) || near(first, s.x1(), s.y1());
    }

    private static boolean near(long[] pixel, int x, int y) {
        return Math.abs(pixel[0] - x) <= 1 && Math.abs(pixel[1] - y) <= 1;
    }

    /** The drawn pixels, moved to where they should be. */
    PixelRecording undo(PixelRecording actual) {
        if (cause.isEmpty()) return actual;
        PixelRecording undone = new PixelRecording(actual.size());
        for (int i = 0; i < actual.size(); i++) {
            long[] pixel = back.of(actual.x(i), actual.y(i));
            undone.plot((int) pixel[0], (int) pixel[1]);
        }
        return undone;
    }
}
