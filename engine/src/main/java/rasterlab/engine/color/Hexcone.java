package rasterlab.engine.color;

/**
 * Red, green, blue ↔ hue, saturation, value of the hexagonal cone.
 *
 * <p>value = max, saturation = (max − min)/max, hue = 60°·(2·k + (next − previous)/(max − min)),
 * where k = 0, 1, 2 stands for a largest red, green, blue, and next and previous are the other two
 * in the circle red → green → blue.
 *
 * <p>Source: A. R. Smith, Color gamut transform pairs, SIGGRAPH 1978, pp. 12–19.
 */
final class Hexcone {
    private Hexcone() {}

    static double[] fromRgb(double[] rgb) {
        double max = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
        double min = Math.min(rgb[0], Math.min(rgb[1], rgb[2]));
        double chroma = max - min;
        if (chroma == 0) return new double[] {Double.NaN, 0, max};
        int k = rgb[0] == max ? 0 : rgb[1] == max ? 1 : 2;
        double side = (rgb[(k + 1) % 3] - rgb[(k + 2) % 3]) / chroma;
        return new double[] {Hue.within(60 * (2 * k + side)), chroma / max, max};
    }

    static double[] toRgb(double[] hsv) {
        double saturation = hsv[1];
        double value = hsv[2];
        if (saturation == 0) return new double[] {value, value, value};
        double sixths = hsv[0] == 360 ? 0 : hsv[0] / 60;
        int sector = (int) sixths;
        double into = sixths - sector;
        double low = value * (1 - saturation);
        double falling = value * (1 - saturation * into);
        double rising = value * (1 - saturation * (1 - into));
        return switch (sector) {
            case 0 -> new double[] {value, rising, low};
            case 1 -> new double[] {falling, value, low};
            case 2 -> new double[] {low, value, rising};
            case 3 -> new double[] {low, falling, value};
            case 4 -> new double[] {rising, low, value};
            default -> new double[] {value, low, falling};
        };
    }
}
