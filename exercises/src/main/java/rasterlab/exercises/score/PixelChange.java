package rasterlab.exercises.score;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;

/**
 * Changes of a set of pixels, each the trace of a mistake that is made in any topic. The text on
 * one is {@code change.NAME}.
 */
enum PixelChange {
    X_AND_Y_SWAPPED(each(one -> new Pixel(one.y(), one.x())), false),
    MIRRORED_LEFT_RIGHT(each(one -> new Pixel(-one.x(), one.y())), true),
    MIRRORED_UP_DOWN(each(one -> new Pixel(one.x(), -one.y())), true),
    MOVED(pixels -> pixels, true),
    FIRST_ROW_LEFT_OUT(only((at, box) -> at.y() > box.top), false),
    LAST_ROW_LEFT_OUT(only((at, box) -> at.y() < box.bottom), false),
    FIRST_COLUMN_LEFT_OUT(only((at, box) -> at.x() > box.left), false),
    LAST_COLUMN_LEFT_OUT(only((at, box) -> at.x() < box.right), false),
    LEFT_HALF_ONLY(only((at, box) -> 2L * at.x() <= (long) box.left + box.right), false),
    RIGHT_HALF_ONLY(only((at, box) -> 2L * at.x() >= (long) box.left + box.right), false),
    UPPER_HALF_ONLY(only((at, box) -> 2L * at.y() <= (long) box.top + box.bottom), false),
    LOWER_HALF_ONLY(only((at, box) -> 2L * at.y() >= (long) box.top + box.bottom), false),
    RUN_BEGINS_LATE(inside(-1, 0), false),
    RUN_ENDS_EARLY(inside(1, 0), false),
    RUN_ENDS_LATE(PixelChange::further, false),
    OUTLINE_ALONE(PixelChange::outline, false),
    ROWS_FILLED(PixelChange::filled, false);

    /** Pixels of a picture that agree by chance in no two. */
    private static final int ENOUGH = 5;

    /** Pixels of a picture beyond which these changes are not tried. */
    private static final int MOST = 100_000;

    private final UnaryOperator<Set<Pixel>> change;
    private final boolean anywhere;

    /**
     * @param anywhere whether the pixels may lie elsewhere, as the axis of a mirror may
     */
    PixelChange(UnaryOperator<Set<Pixel>> change, boolean anywhere) {
        this.change = change;
        this.anywhere = anywhere;
    }

    /** Names of the changes by which the one comes from the other. */
    static Stream<String> of(PixelRecording right, PixelRecording actual) {
        if (right.size() > MOST || actual.size() > MOST) return Stream.of();
        Set<Pixel> wanted = set(right);
        Set<Pixel> drawn = set(actual);
        boolean tells = wanted.size() >= ENOUGH && drawn.size() == actual.size();
        if (!tells || drawn.isEmpty()) return Stream.of();
        return Stream.of(values())
                .filter(one -> one.makes(drawn, wanted))
                .filter(one -> one == MOVED || !one.makes(wanted, wanted))
                .map(PixelChange::word);
    }

    /** Whether the one comes from the other by the change of that name. */
    static boolean makes(String word, PixelRecording right, PixelRecording actual) {
        if (right.size() == 0 || actual.size() == 0) return right.size() == actual.size();
        return Stream.of(values())
                .filter(one -> one.word().equals(word))
                .filter(one -> one == MOVED || !one.makes(set(right), set(right)))
                .anyMatch(one -> one.makes(set(actual), set(right)));
    }

    /** Whether the change of that name leaves the pixels as they are. */
    static boolean leaves(String word, PixelRecording pixels) {
        Set<Pixel> right = set(pixels);
        return pixels.size() > MOST
                || Stream.of(values())
                        .filter(one -> one.word().equals(word) && one != MOVED)
                        .allMatch(one -> right.isEmpty() || one.makes(right, right));
    }

    private boolean makes(Set<Pixel> drawn, Set<Pixel> right) {
        Set<Pixel> changed = change.apply(right);
        if (changed.size() != drawn.size()) return false;
        return anywhere ? atTheOrigin(changed).equals(atTheOrigin(drawn)) : changed.equals(drawn);
    }

    private String word() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static Set<Pixel> set(PixelRecording pixels) {
        Set<Pixel> set = new HashSet<>();
        for (int i = 0; i < pixels.size(); i++) set.add(new Pixel(pixels.x(i), pixels.y(i)));
        return set;
    }

    private record Box(int left, int top, int right, int bottom) {
        static Box of(Set<Pixel> pixels) {
            var x = pixels.stream().mapToInt(Pixel::x).summaryStatistics();
            var y = pixels.stream().mapToInt(Pixel::y).summaryStatistics();
            return new Box(x.getMin(), y.getMin(), x.getMax(), y.getMax());
        }
    }

    private static Set<Pixel> atTheOrigin(Set<Pixel> pixels) {
        Box box = Box.of(pixels);
        return each(one -> new Pixel(one.x() - box.left, one.y() - box.top)).apply(pixels);
    }

    private static UnaryOperator<Set<Pixel>> each(UnaryOperator<Pixel> change) {
        return pixels -> {
            Set<Pixel> changed = new HashSet<>();
            for (Pixel one : pixels) changed.add(change.apply(one));
            return changed;
        };
    }

    private static UnaryOperator<Set<Pixel>> only(BiPredicate<Pixel, Box> kept) {
        return pixels -> {
            Box box = Box.of(pixels);
            Set<Pixel> left = new HashSet<>(pixels);
            left.removeIf(one -> !kept.test(one, box));
            return left;
        };
    }

    /** The pixels that have a neighbour there. */
    private static UnaryOperator<Set<Pixel>> inside(int dx, int dy) {
        return pixels -> {
            Set<Pixel> left = new HashSet<>(pixels);
            left.removeIf(one -> !pixels.contains(new Pixel(one.x() + dx, one.y() + dy)));
            return left;
        };
    }

    private static Set<Pixel> further(Set<Pixel> pixels) {
        Set<Pixel> more = each(one -> new Pixel(one.x() + 1, one.y())).apply(pixels);
        more.addAll(pixels);
        return more;
    }

    private static Set<Pixel> outline(Set<Pixel> pixels) {
        Set<Pixel> middle = inside(1, 0).apply(pixels);
        middle.retainAll(inside(-1, 0).apply(pixels));
        middle.retainAll(inside(0, 1).apply(pixels));
        middle.retainAll(inside(0, -1).apply(pixels));
        Set<Pixel> left = new HashSet<>(pixels);
        left.removeAll(middle);
        return left;
    }

    /** Each row from its first pixel to its last, where that is no more than a picture has. */
    private static Set<Pixel> filled(Set<Pixel> pixels) {
        Box box = Box.of(pixels);
        long area = (box.right - (long) box.left + 1) * (box.bottom - (long) box.top + 1);
        if (area > MOST) return pixels;
        var runs = new TreeMap<Integer, int[]>();
        for (Pixel one : pixels) {
            int[] run = runs.computeIfAbsent(one.y(), y -> new int[] {one.x(), one.x()});
            run[0] = Math.min(run[0], one.x());
            run[1] = Math.max(run[1], one.x());
        }
        Set<Pixel> all = new HashSet<>();
        runs.forEach(
                (y, run) -> {
                    for (int x = run[0]; x <= run[1]; x++) all.add(new Pixel(x, y));
                });
        return all;
    }
}
