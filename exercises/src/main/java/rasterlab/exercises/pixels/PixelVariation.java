package rasterlab.exercises.pixels;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelRecording;

/**
 * Pixels with a mistake, made from the right ones.
 *
 * @param codes of the mistake, as {@link PixelMistakes} has them
 * @param way plots the line with it
 */
record PixelVariation(Set<String> codes, Way way) {
    static final PixelVariation RIGHT = each(Set.of(), (s, x, y, out) -> out.plot(x, y));

    private static final List<PixelVariation> ALL = all();

    /** Draws from the right pixels. */
    private interface Way {
        void plot(PixelRecording right, Pixels out);
    }

    /** The first pixel and the last one. */
    private record Ends(int x0, int y0, int x1, int y1) {
        static Ends of(PixelRecording right) {
            int last = right.size() - 1;
            return new Ends(right.x(0), right.y(0), right.x(last), right.y(last));
        }
    }

    /** Draws what comes of one right pixel. */
    private interface EachPixel {
        void plot(Ends s, int x, int y, Pixels out);
    }

    void draw(PixelRecording right, Pixels out) {
        way.plot(right, out);
    }

    /** Tries the variation that fitted last before all others. */
    static final class Likely {
        private PixelVariation last = ALL.get(0);

        Optional<PixelVariation> first(Predicate<PixelVariation> fits) {
            if (fits.test(last)) return Optional.of(last);
            Optional<PixelVariation> found =
                    ALL.stream().filter(one -> one != last).filter(fits).findFirst();
            found.ifPresent(one -> last = one);
            return found;
        }
    }

    private static List<PixelVariation> all() {
        List<PixelVariation> all = new ArrayList<>();
        for (int start = -1; start <= 1; start++)
            for (int end = -1; end <= 1; end++)
                for (boolean straight : new boolean[] {false, true})
                    if (start > 0 || end > 0 || !straight && (start != 0 || end != 0))
                        all.add(atEnds(start, end, straight));
        all.add(each(Set.of("again"), (s, x, y, out) -> plot(2, x, y, out)));
        all.add(
                each(
                        Set.of("again"),
                        (s, x, y, out) -> plot(x == s.x1() && y == s.y1() ? 2 : 1, x, y, out)));
        all.add(
                each(
                        Set.of("again"),
                        (s, x, y, out) -> plot(x == s.x0() && y == s.y0() ? 2 : 1, x, y, out)));
        all.add(moved("mirrored-left-right", (s, x, y, out) -> out.plot(2 * s.x0() - x, y)));
        all.add(moved("mirrored-up-down", (s, x, y, out) -> out.plot(x, 2 * s.y0() - y)));
        all.add(
                each(
                        Set.of("mirrored-left-right", "mirrored-up-down"),
                        (s, x, y, out) -> out.plot(2 * s.x0() - x, 2 * s.y0() - y)));
        all.add(
                each(
                        Set.of("mirrored-left-right", "mirrored-up-down"),
                        (s, x, y, out) ->
                                out.plot(
                                        s.x0() + Math.abs(x - s.x0()),
                                        s.y0() + Math.abs(y - s.y0()))));
        all.add(moved("mirrored-left-right", (s, x, y, out) -> out.plot(-x, y)));
        all.add(moved("mirrored-up-down", (s, x, y, out) -> out.plot(x, -y)));
        all.add(moved("swapped-axes", (s, x, y, out) -> out.plot(y, x)));
        all.add(
                moved(
                        "swapped-axes",
                        (s, x, y, out) -> out.plot(s.x0() + y - s.y0(), s.y0() + x - s.x0())));
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) {
                int right = dx;
                int down = dy;
                if (dx != 0 || dy != 0)
                    all.add(moved("shifted", (s, x, y, out) -> out.plot(x + right, y + down)));
            }
        return List.copyOf(all);
    }

    /**
     * One pixel less at an end, or one beyond it.
     *
     * @param start −1 where the first pixel is missing, 1 where one comes before it
     * @param end the same of the last
     * @param straight whether a pixel beyond lies on the longer axis, and not where the path, which
     *     repeats itself after each such length, goes on
     */
    private static PixelVariation atEnds(int start, int end, boolean straight) {
        Set<String> codes =
                start == -end
                        ? Set.of("shifted")
                        : Set.copyOf(both(code(start, "first-pixel"), code(end, "last-pixel")));
        Way way =
                (right, out) -> {
                    Ends s = Ends.of(right);
                    int n = right.size() - 1;
                    if (start > 0)
                        out.plot(
                                s.x0() - step(right, n, s, straight, true),
                                s.y0() - step(right, n, s, straight, false));
                    for (int i = start < 0 ? 1 : 0; i < right.size() - (end < 0 ? 1 : 0); i++)
                        out.plot(right.x(i), right.y(i));
                    if (end > 0)
                        out.plot(
                                s.x1() + step(right, 1, s, straight, true),
                                s.y1() + step(right, 1, s, straight, false));
                };
        return new PixelVariation(codes, way);
    }

    private static String code(int off, String end) {
        return off == 0 ? "" : off > 0 ? "beyond-" + end : end;
    }

    private static List<String> both(String one, String other) {
        return one.isEmpty() || other.isEmpty() ? List.of(one + other) : List.of(one, other);
    }

    /**
     * The step in x or y from pixel i − 1 to pixel i; where it is to be straight, along the longer
     * axis.
     */
    private static int step(PixelRecording right, int i, Ends s, boolean straight, boolean inX) {
        boolean steep = Math.abs(s.y1() - s.y0()) > Math.abs(s.x1() - s.x0());
        if (straight && inX == steep) return 0;
        return inX ? right.x(i) - right.x(i - 1) : right.y(i) - right.y(i - 1);
    }

    private static PixelVariation moved(String code, EachPixel way) {
        return each(Set.of(code), way);
    }

    private static PixelVariation each(Set<String> codes, EachPixel way) {
        return new PixelVariation(
                codes,
                (right, out) -> {
                    Ends s = Ends.of(right);
                    for (int i = 0; i < right.size(); i++) way.plot(s, right.x(i), right.y(i), out);
                });
    }

    private static void plot(int times, int x, int y, Pixels out) {
        for (int left = times; left > 0; left--) out.plot(x, y);
    }
}
