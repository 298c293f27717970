package rasterlab.engine.color;

/**
 * Red, green, blue ↔ inks, which take light from white paper.
 *
 * <p>c = 1 − r, m = 1 − g, y = 1 − b; with black k = 1 − max and c' = (max − r)/max, the share of
 * what black leaves. Black itself has no other ink.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 7,
 * "the RGB cube" (cmy, and what the fourth ink is for); J. D. Foley, A. van Dam, S. K. Feiner, J.
 * F. Hughes, Computer Graphics: Principles and Practice, 1990, chapter 13 (taking out black).
 */
final class Inks {
    private Inks() {}

    static double[] cmyFromRgb(double[] rgb) {
        return new double[] {1 - rgb[0], 1 - rgb[1], 1 - rgb[2]};
    }

    static double[] cmyToRgb(double[] cmy) {
        return new double[] {1 - cmy[0], 1 - cmy[1], 1 - cmy[2]};
    }

    static double[] cmykFromRgb(double[] rgb) {
        double max = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
        if (max == 0) return new double[] {0, 0, 0, 1};
        return new double[] {
            (max - rgb[0]) / max, (max - rgb[1]) / max, (max - rgb[2]) / max, 1 - max
        };
    }

    static double[] cmykToRgb(double[] cmyk) {
        double left = 1 - cmyk[3];
        return new double[] {(1 - cmyk[0]) * left, (1 - cmyk[1]) * left, (1 - cmyk[2]) * left};
    }
}
