import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

/** Goes by red, green and blue, and writes these as usual. */
public class Model implements ColorConverter {
    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        return fromRgb(to, toRgb(from, components));
    }

    private static double[] toRgb(ColorModel from, double[] c) {
        return switch (from) {
            case RGB -> c.clone();
            case CMY -> new double[] {1 - c[0], 1 - c[1], 1 - c[2]};
            case CMYK ->
                    new double[] {
                        (1 - c[0]) * (1 - c[3]), (1 - c[1]) * (1 - c[3]), (1 - c[2]) * (1 - c[3])
                    };
            case HSV -> ofHsv(c[0], c[1], c[2]);
            case HVS -> ofHvs(c[0], c[1], c[2]);
        };
    }

    private static double[] ofHsv(double hue, double saturation, double value) {
        if (saturation == 0) return new double[] {value, value, value};
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            double k = (5 - 2 * i + hue / 60) % 6;
            rgb[i] = value - value * saturation * Math.max(0, Math.min(1, Math.min(k, 4 - k)));
        }
        return rgb;
    }

    private static double[] ofHvs(double hue, double value, double saturation) {
        double gray = value / Math.sqrt(3);
        double angle = saturation == 0 ? 0 : Math.toRadians(hue);
        double along = saturation * Math.cos(angle) / Math.sqrt(6);
        double across = saturation * Math.sin(angle) / Math.sqrt(2);
        return new double[] {
            cut(gray + 2 * along), cut(gray - along + across), cut(gray - along - across)
        };
    }

    private static double cut(double share) {
        return Math.max(0, Math.min(1, share));
    }

    private static double[] fromRgb(ColorModel to, double[] rgb) {
        double r = rgb[0];
        double g = rgb[1];
        double b = rgb[2];
        double max = Math.max(r, Math.max(g, b));
        double min = Math.min(r, Math.min(g, b));
        return switch (to) {
            case RGB -> rgb;
            case CMY -> new double[] {1 - r, 1 - g, 1 - b};
            case CMYK ->
                    max == 0
                            ? new double[] {0, 0, 0, 1}
                            : new double[] {
                                (max - r) / max, (max - g) / max, (max - b) / max, 1 - max
                            };
            case HSV ->
                    max == min
                            ? new double[] {Double.NaN, 0, max}
                            : new double[] {sixths(r, g, b, max, min), (max - min) / max, max};
            case HVS -> hvs(r, g, b);
        };
    }

    private static double sixths(double r, double g, double b, double max, double min) {
        double side;
        if (r == max) side = (g - b) / (max - min);
        else if (g == max) side = 2 + (b - r) / (max - min);
        else side = 4 + (r - g) / (max - min);
        return turn(60 * side);
    }

    private static double[] hvs(double r, double g, double b) {
        double value = (r + g + b) / Math.sqrt(3);
        if (r == g && g == b) return new double[] {Double.NaN, value, 0};
        double saturation =
                Math.sqrt(((r - g) * (r - g) + (g - b) * (g - b) + (b - r) * (b - r)) / 3);
        double hue = Math.toDegrees(Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b));
        return new double[] {turn(hue), value, saturation};
    }

    /** The turn, from 0 to below 360. */
    private static double turn(double degrees) {
        double positive = degrees < 0 ? degrees + 360 : degrees;
        return positive >= 360 ? 0 : positive;
    }
}
