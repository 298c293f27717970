package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Message;

/**
 * Where a line lies that is right but for its place.
 *
 * @param causes why it lies there; none where it lies right
 * @param line what it should be, once its pixels are brought back
 * @param back brings a pixel to where it should be
 */
record LinePlace(List<Cause> causes, Segment line, Motion back) {
    private static final Motion NONE = (x, y) -> new long[] {x, y};

    /** Moves a pixel; beyond the range of int it wraps, which then fits no line. */
    interface Motion {
        long[] of(long x, long y);
    }

    /** The places that can be told by the first pixel, the right one first. */
    static List<LinePlace> of(Segment s, PixelRecording actual) {
        List<LinePlace> places = new ArrayList<>();
        places.add(new LinePlace(List.of(), s, NONE));
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) if (dx != 0 || dy != 0) places.add(shifted(s, dx, dy));
        Cause leftRight = Cause.of("mirrored-left-right");
        Cause upDown = Cause.of("mirrored-up-down");
        mirrored(places, s, List.of(wrongWay("x", leftRight)), 2L * s.x0(), -1, 0, 1);
        mirrored(places, s, List.of(wrongWay("y", upDown)), 0, 1, 2L * s.y0(), -1);
        mirrored(
                places,
                s,
                List.of(wrongWay("x", leftRight), wrongWay("y", upDown)),
                2L * s.x0(),
                -1,
                2L * s.y0(),
                -1);
        mirrored(places, s, List.of(leftRight), 0, -1, 0, 1);
        mirrored(places, s, List.of(upDown), 0, 1, 0, -1);
        List<Cause> swapped = List.of(Cause.of("swapped-axes"));
        places.add(new LinePlace(swapped, s, (x, y) -> new long[] {y, x}));
        places.add(
                new LinePlace(
                        swapped,
                        s,
                        (x, y) -> new long[] {s.x0() + (y - s.y0()), s.y0() + (x - s.x0())}));
        return places.stream().filter(place -> place.meetsAnEnd(actual)).toList();
    }

    /** The same mistake as being mirrored, but the first end stays where it is. */
    private static Cause wrongWay(String axis, Cause mirrored) {
        return new Cause(mirrored.code(), Message.of("mistake.wrong-way-" + axis));
    }

    private static LinePlace shifted(Segment s, int dx, int dy) {
        return new LinePlace(
                List.of(Cause.of("shifted", signed(dx), signed(dy))),
                s,
                (x, y) -> new long[] {x - dx, y - dy});
    }

    private static String signed(int distance) {
        return distance > 0 ? "+" + distance : String.valueOf(distance);
    }

    /**
     * Adds the place of pixels that went to (ox + fx·x, oy + fy·y), and that of a line between ends
     * that did: the two differ where there are ties.
     */
    private static void mirrored(
            List<LinePlace> places,
            Segment s,
            List<Cause> causes,
            long ox,
            int fx,
            long oy,
            int fy) {
        Motion motion = (x, y) -> new long[] {ox + fx * x, oy + fy * y};
        places.add(new LinePlace(causes, s, motion));
        long[] from = motion.of(s.x0(), s.y0());
        long[] to = motion.of(s.x1(), s.y1());
        if (isPixel(from) && isPixel(to))
            places.add(
                    new LinePlace(
                            causes,
                            new Segment((int) from[0], (int) from[1], (int) to[0], (int) to[1]),
                            NONE));
    }

    private static boolean isPixel(long[] pixel) {
        return pixel[0] == (int) pixel[0] && pixel[1] == (int) pixel[1];
    }

    /** Whether the first pixel is brought to an end or beside one: all others are not tried. */
    private boolean meetsAnEnd(PixelRecording actual) {
        long[] first = back.of(actual.x(0), actual.y(0));
        return near(first, line.x0(), line.y0()) || near(first, line.x1(), line.y1());
    }

    private static boolean near(long[] pixel, int x, int y) {
        return Math.abs(pixel[0] - x) <= 1 && Math.abs(pixel[1] - y) <= 1;
    }

    /** The drawn pixels, moved to where they should be. */
    PixelRecording undo(PixelRecording actual) {
        if (back == NONE) return actual;
        PixelRecording undone = new PixelRecording(actual.size());
        for (int i = 0; i < actual.size(); i++) {
            long[] pixel = back.of(actual.x(i), actual.y(i));
            undone.plot((int) pixel[0], (int) pixel[1]);
        }
        return undone;
    }
}
