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
        double[] corners = corners(index);
        double[] box = box(corners);
        var sum = new double[4];
        double area = 0;
        for (int j = (int) Math.floor(box[1]); j < box[3]; j++)
            for (int i = (int) Math.floor(box[0]); i < box[2]; i++) {
                double part = common(corners, i, j);
                area += part;
                int argb = texel(i, j);
                for (int c = 0; c < 4; c++) sum[c] += part * (argb >>> 24 - 8 * c & 255);
            }
        if (area < SMALLEST) return point(index);
        for (int c = 0; c < 4; c++) sum[c] /= area;
        return sum;
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

    /** The four corners in texels. */
    private double[] corners(int index) {
        double[] f =
                Arrays.copyOfRange(
                        pixels.footprints(),
                        index * FilteredPixels.NUMBERS,
                        (index + 1) * FilteredPixels.NUMBERS);
        var corners = new double[8];
        int[][] signs = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (int k = 0; k < 4; k++) {
            corners[2 * k] =
                    pixels.width() * (f[0] + (signs[k][0] * f[2] + signs[k][1] * f[4]) / 2);
            corners[2 * k + 1] =
                    pixels.height() * (f[1] + (signs[k][0] * f[3] + signs[k][1] * f[5]) / 2);
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

    /** The area that the parallelogram has in common with texel (i, j). */
    private static double common(double[] corners, int i, int j) {
        double[] part = corners;
        part = cut(part, 0, i, 1);
        part = cut(part, 0, i + 1, -1);
        part = cut(part, 1, j, 1);
        part = cut(part, 1, j + 1, -1);
        double twice = 0;
        for (int k = 0; k < part.length; k += 2) {
            int next = (k + 2) % part.length;
            // Relative to a corner, or areas far away or as thin as rounding lose their digits.
            twice +=
                    (part[k] - part[0]) * (part[next + 1] - part[1])
                            - (part[next] - part[0]) * (part[k + 1] - part[1]);
        }
        return Math.abs(twice) / 2;
    }

    /** What of a convex polygon lies where side·(coordinate − at) is not negative. */
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
