package rasterlab.engine.texture.filter;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Footprints that show what a filter leaves out. */
final class FilterHazards {
    private FilterHazards() {}

    static List<Hazard<FilteredPixels>> all() {
        return Stream.of(smaller(), shaped(), places(), left(), thin())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<FilteredPixels>> smaller() {
        return List.of(
                hazard("one-to-one", row(checkers(16), 1, 1, 0), EXACT, EXACT, EXACT, EXACT, EXACT),
                hazard(
                        "aliasing",
                        row(thirds(), 8, 8, 0.1),
                        WRONG,
                        WRONG,
                        DEGRADED,
                        DEGRADED,
                        EXACT),
                hazard(
                        "between-levels",
                        row(stairs(), 3, 3, 0.3),
                        WRONG,
                        WRONG,
                        WRONG,
                        DEGRADED,
                        EXACT));
    }

    private static List<Hazard<FilteredPixels>> shaped() {
        return List.of(
                hazard(
                        "long-and-narrow",
                        row(stripes(64), 1, 16, 0),
                        EXACT,
                        EXACT,
                        WRONG,
                        WRONG,
                        EXACT),
                hazard(
                        "long-over-rows",
                        row(rows(64), 1, 16, 0),
                        WRONG,
                        WRONG,
                        EXACT,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<FilteredPixels>> left() {
        return List.of(
                hazard(
                        "left-of-the-border",
                        row(picture(4, (i, j) -> 64 * i), 1, 1, -16),
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<FilteredPixels>> thin() {
        return List.of(
                hazard(
                        "hair",
                        new FilteredPixels(
                                4,
                                2,
                                new int[] {0, 0, 0, 0, 0, 0, 0, -1},
                                new double[] {1 - 0x1p-25, 0, 0x1p-27, 0, 0, 1}),
                        WRONG,
                        WRONG,
                        WRONG,
                        WRONG,
                        EXACT));
    }

    private static List<Hazard<FilteredPixels>> places() {
        return List.of(
                hazard(
                        "no-area",
                        new FilteredPixels(
                                4,
                                4,
                                stripes(4).argb(),
                                new double[] {
                                    0.5, 0.5, 0, 0, 0, 0, 0.25, 0.1, 0, 0, 0, 0, 0.75, 0.5, 0, 0, 0,
                                    0.5, 0.5, 0.5, 1, 0, 0, 0
                                }),
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "bottom-row-first",
                        row(picture(8, (i, j) -> 32 * j), 1, 1, 0),
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "beyond-the-border",
                        row(picture(4, (i, j) -> 64 * i), 1, 1, 0),
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "magnified",
                        row(stripes(4), 0.125, 0.125, 0),
                        EXACT,
                        WRONG,
                        EXACT,
                        WRONG,
                        EXACT),
                hazard(
                        "turned",
                        new FilteredPixels(
                                48,
                                48,
                                thirds().argb(),
                                new double[] {0.51, 0.5, 0.1, 0.1, -0.1, 0.1}),
                        WRONG,
                        WRONG,
                        DEGRADED,
                        DEGRADED,
                        REFUSED));
    }

    /** Sixteen pixels side by side. */
    private static FilteredPixels row(
            FilteredPixels picture, double wide, double high, double offset) {
        double stepS = wide / picture.width();
        double stepT = high / picture.height();
        var footprints = new double[16 * FilteredPixels.NUMBERS];
        for (int i = 0; i < 16; i++) {
            int at = i * FilteredPixels.NUMBERS;
            footprints[at] = (i + 0.5) * stepS + offset / picture.width();
            footprints[at + 1] = 0.5 * stepT;
            footprints[at + 2] = stepS;
            footprints[at + 5] = stepT;
        }
        return new FilteredPixels(picture.width(), picture.height(), picture.argb(), footprints);
    }

    private static FilteredPixels checkers(int size) {
        return picture(size, (i, j) -> (i + j) % 2 == 0 ? 255 : 0);
    }

    private static FilteredPixels stripes(int size) {
        return picture(size, (i, j) -> i % 2 == 0 ? 255 : 0);
    }

    private static FilteredPixels rows(int size) {
        return picture(size, (i, j) -> j % 5 == 0 ? 255 : 0);
    }

    private static FilteredPixels stairs() {
        return picture(32, (i, j) -> 64 * (i / 8));
    }

    private static FilteredPixels thirds() {
        return picture(48, (i, j) -> i % 3 == 0 ? 255 : 0);
    }

    /** A grey level for each texel. */
    @FunctionalInterface
    private interface Gray {
        int at(int i, int j);
    }

    private static FilteredPixels picture(int size, Gray gray) {
        var argb = new int[size * size];
        for (int k = 0; k < argb.length; k++)
            argb[k] = 0xFF000000 | 0x010101 * gray.at(k % size, k / size);
        return new FilteredPixels(size, size, argb, new double[0]);
    }

    private static Hazard<FilteredPixels> hazard(
            String name,
            FilteredPixels pixels,
            Verdict.Kind nearest,
            Verdict.Kind linear,
            Verdict.Kind mipmap,
            Verdict.Kind trilinear,
            Verdict.Kind summed) {
        return new Hazard<>(
                name,
                pixels,
                Map.of(
                        "nearest",
                        nearest,
                        "linear",
                        linear,
                        "mipmap-nearest",
                        mipmap,
                        "trilinear",
                        trilinear,
                        "summed-area",
                        summed,
                        "nearest-textbook",
                        name.equals("left-of-the-border") ? WRONG : nearest));
    }
}
