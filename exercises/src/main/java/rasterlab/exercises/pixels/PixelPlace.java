package rasterlab.exercises.pixels;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Message;

/**
 * A place where a path lies that is right but for its place.
 *
 * @param causes why it lies there; none where it lies right
 * @param path what it should be, once its pixels are brought back
 * @param back brings a pixel to where it should be
 */
record PixelPlace(List<Cause> causes, PixelPath path, Motion back) {
    private static final Motion NONE = (x, y) -> new long[] {x, y};

    /** Moves a pixel; beyond the range of int it wraps, which then fits no path. */
    interface Motion {
        long[] of(long x, long y);
    }

    /** The places that can be told by the first pixel, the right one first. */
    static List<PixelPlace> of(PixelPath s, PixelRecording actual) {
        Pixel first = s.first();
        List<PixelPlace> places = new ArrayList<>();
        places.add(new PixelPlace(List.of(), s, NONE));
        if (!isBetweenItsEnds(s, actual)) addShifted(places, s);
        Cause leftRight = Cause.of("mirrored-left-right");
        Cause upDown = Cause.of("mirrored-up-down");
        mirrored(places, s, List.of(wrongWay("x", leftRight)), 2L * first.x(), -1, 0, 1);
        mirrored(places, s, List.of(wrongWay("y", upDown)), 0, 1, 2L * first.y(), -1);
        mirrored(
                places,
                s,
                List.of(wrongWay("x", leftRight), wrongWay("y", upDown)),
                2L * first.x(),
                -1,
                2L * first.y(),
                -1);
        mirrored(places, s, List.of(leftRight), 0, -1, 0, 1);
        mirrored(places, s, List.of(upDown), 0, 1, 0, -1);
        List<Cause> swapped = List.of(Cause.of("swapped-axes"));
        places.add(new PixelPlace(swapped, s, (x, y) -> new long[] {y, x}));
        places.add(
                new PixelPlace(
                        swapped,
                        s,
                        (x, y) ->
                                new long[] {
                                    first.x() + (y - first.y()), first.y() + (x - first.x())
                                }));
        return places.stream().filter(place -> place.meetsAnEnd(actual)).toList();
    }

    /** The cause of a path that is mirrored about its first end, which stays where it is. */
    private static Cause wrongWay(String axis, Cause mirrored) {
        return new Cause(mirrored.code(), Message.of("mistake.wrong-way-" + axis));
    }

    /**
     * Whether it is drawn from one of the path's ends to the other: it is not shifted then, though
     * a shift and one more along the path may take each other back at the ends.
     */
    private static boolean isBetweenItsEnds(PixelPath s, PixelRecording actual) {
        Pixel from = new Pixel(actual.x(0), actual.y(0));
        Pixel to = new Pixel(actual.x(actual.size() - 1), actual.y(actual.size() - 1));
        return from.equals(s.first()) && to.equals(s.last())
                || from.equals(s.last()) && to.equals(s.first());
    }

    private static void addShifted(List<PixelPlace> places, PixelPath s) {
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) if (dx != 0 || dy != 0) places.add(shifted(s, dx, dy));
    }

    private static PixelPlace shifted(PixelPath s, int dx, int dy) {
        return new PixelPlace(
                List.of(Cause.of("shifted", signed(dx), signed(dy))),
                s,
                (x, y) -> new long[] {x - dx, y - dy});
    }

    private static String signed(int distance) {
        return distance > 0 ? "+" + distance : String.valueOf(distance);
    }

    /**
     * Adds the place of pixels that went to (ox + fx·x, oy + fy·y), and that of a path between ends
     * that did: the two differ where there are ties.
     */
    private static void mirrored(
            List<PixelPlace> places,
            PixelPath s,
            List<Cause> causes,
            long ox,
            int fx,
            long oy,
            int fy) {
        Motion motion = (x, y) -> new long[] {ox + fx * x, oy + fy * y};
        places.add(new PixelPlace(causes, s, motion));
        long[] from = motion.of(s.first().x(), s.first().y());
        long[] to = motion.of(s.last().x(), s.last().y());
        if (isPixel(from) && isPixel(to))
            places.add(new PixelPlace(causes, s.between(pixel(from), pixel(to)), NONE));
    }

    private static Pixel pixel(long[] at) {
        return new Pixel((int) at[0], (int) at[1]);
    }

    private static boolean isPixel(long[] pixel) {
        return pixel[0] == (int) pixel[0] && pixel[1] == (int) pixel[1];
    }

    /** Whether the first pixel is brought to an end or beside one: all others are not tried. */
    private boolean meetsAnEnd(PixelRecording actual) {
        long[] first = back.of(actual.x(0), actual.y(0));
        return near(first, path.first()) || near(first, path.last());
    }

    private static boolean near(long[] pixel, Pixel end) {
        return Math.abs(pixel[0] - end.x()) <= 1 && Math.abs(pixel[1] - end.y()) <= 1;
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
