package rasterlab.engine.texture.filter;

import java.util.Arrays;

/**
 * The mean of a repeated picture over a parallelogram: every texel it touches, by the area of what
 * the parallelogram has of it.
 */
final class ExactFootprint {
    private static final double SMALLEST = 1e-12;

    private final FilteredPixels pixels;

    ExactFootprint(FilteredPixels pixels) {
        this.pixels = pixels;
    }

    /** Alpha, red, green, blue, 0 to 255, of pixel {@code index}. */
    double[] mean(int index) {
        double[] f =
                Arrays.copyOfRange(
                        pixels.footprints(),
                        index * FilteredPixels.NUMBERS,
                        (index + 1) * FilteredPixels.NUMBERS);
        double[] corners = corners(f);
        double[] box = box(corners);
        double u = pixels.width() * f[0];
        double v = pixels.height() * f[1];
        var sum = new double[4];
        double area = 0;
        // The range has one texel more on each side, since the middle is rounded here.
        for (int j = (int) Math.floor(v + box[1]) - 1; j <= v + box[3] + 1; j++)
            for (int i = (int) Math.floor(u + box[0]) - 1; i <= u + box[2] + 1; i++) {
                double part =
                        common(
                                corners,
                                fromMiddle(i, pixels.width(), f[0]),
                                fromMiddle(j, pixels.height(), f[1]));
                area += part;
                int argb = texel(i, j);
                for (int c = 0; c < 4; c++) sum[c] += part * (argb >>> 24 - 8 * c & 255);
            }
        if (area < SMALLEST) return point(index);
        for (int c = 0; c < 4; c++) sum[c] /= area;
        return sum;
    }

    /**
     * How far a texel's lower and upper border lie from the middle of the footprint, in texels: the
     * product is not rounded, for a footprint may be narrower than its rounding.
     */
    private static double[] fromMiddle(int texel, int size, double middle) {
        double rounded = size * middle;
        double rest = Math.fma(size, middle, -rounded);
        return new double[] {texel - rounded - rest, texel + 1 - rounded - rest};
    }

    /** A footprint without an area shows the texel it lies in. */
    private double[] point(int index) {
        int at = index * FilteredPixels.NUMBERS;
        int argb =
                texel(
                        (int) Math.floor(pixels.footprints()[at] * pixels.width()),
                        (int) Math.floor(pixels.footprints()[at + 1] * pixels.height()));
        return new double[] {argb >>> 24, argb >> 16 & 255, argb >> 8 & 255, argb & 255};
    }

    private int texel(int i, int j) {
        return pixels.argb()[
                Math.floorMod(j, pixels.height()) * pixels.width()
                        + Math.floorMod(i, pixels.width())];
    }

    /** The four corners in texels, from the middle of the footprint. */
    private double[] corners(double[] f) {
        var corners = new double[8];
        int[][] signs = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (int k = 0; k < 4; k++) {
            corners[2 * k] = pixels.width() * (signs[k][0] * f[2] + signs[k][1] * f[4]) / 2;
            corners[2 * k + 1] = pixels.height() * (signs[k][0] * f[3] + signs[k][1] * f[5]) / 2;
        }
        return corners;
    }

    private static double[] box(double[] corners) {
        double[] box = {corners[0], corners[1], corners[0], corners[1]};
        for (int k = 2; k < 8; k += 2)
            for (int c = 0; c < 2; c++) {
                box[c] = Math.min(box[c], corners[k + c]);
                box[2 + c] = Math.max(box[2 + c], corners[k + c]);
            }
        return box;
    }

    /**
     * The area that the parallelogram has in common with a texel.
     *
     * @param columns where the texel begins and ends, from the middle of the parallelogram
     * @param rows the same downwards
     */
    private static double common(double[] corners, double[] columns, double[] rows) {
        double[] part = corners;
        part = cut(part, 0, columns[0], 1);
        part = cut(part, 0, columns[1], -1);
        part = cut(part, 1, rows[0], 1);
        part = cut(part, 1, rows[1], -1);
        double twice = 0;
        for (int k = 0; k < part.length; k += 2) {
            int next = (k + 2) % part.length;
            // The area is summed relative to a corner: far or very thin ones would lose their
            // digits.
            twice +=
                    (part[k] - part[0]) * (part[next + 1] - part[1])
                            - (part[next] - part[0]) * (part[k + 1] - part[1]);
        }
        return Math.abs(twice) / 2;
    }

    /** The part of a convex polygon where side·(coordinate − at) is not negative. */
    private static double[] cut(double[] polygon, int axis, double at, int side) {
        var kept = new double[polygon.length + 4];
        int size = 0;
        for (int k = 0; k < polygon.length; k += 2) {
            int next = (k + 2) % polygon.length;
            double here = side * (polygon[k + axis] - at);
            double there = side * (polygon[next + axis] - at);
            if (here >= 0) {
                kept[size++] = polygon[k];
                kept[size++] = polygon[k + 1];
            }
            if (here < 0 != there < 0) {
                double f = here / (here - there);
                kept[size++] = polygon[k] + f * (polygon[next] - polygon[k]);
                kept[size++] = polygon[k + 1] + f * (polygon[next + 1] - polygon[k + 1]);
            }
        }
        return Arrays.copyOf(kept, size);
    }
}
