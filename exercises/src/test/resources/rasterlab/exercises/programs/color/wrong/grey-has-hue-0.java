import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;

public class HueZero implements ColorConverter {
    @Override
    public double[] convert(ColorModel from, double[] components, ColorModel to) {
        double[] rgb = light(from, components);
        double r = rgb[0], g = rgb[1], b = rgb[2];
        double most = Math.max(r, Math.max(g, b)), least = Math.min(r, Math.min(g, b));
        switch (to) {
            case RGB:
                return new double[] {r, g, b};
            case CMY:
                return new double[] {1 - r, 1 - g, 1 - b};
            case CMYK:
                if (most == 0) return new double[] {0, 0, 0, 1};
                return new double[] {(most - r) / most, (most - g) / most, (most - b) / most, 1 - most};
            case HSV:
                return new double[] {hexagon(r, g, b, most, least), most == 0 ? 0 : (most - least) / most, most};
            default:
                double s = Math.sqrt(((r - g) * (r - g) + (g - b) * (g - b) + (b - r) * (b - r)) / 3);
                return new double[] {circle(r, g, b), (r + g + b) / Math.sqrt(3), s};
        }
    }

    private static double hexagon(double r, double g, double b, double most, double least) {
        if (most == least) return 0;
        double span = most - least;
        double h = most == r ? (g - b) / span : most == g ? 2 + (b - r) / span : 4 + (r - g) / span;
        return h < 0 ? 60 * h + 360 : 60 * h;
    }

    private static double circle(double r, double g, double b) {
        if (r == g && g == b) return 0;
        double h = Math.toDegrees(Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b));
        return h < 0 ? h + 360 : h;
    }

    private static double[] light(ColorModel from, double[] c) {
        switch (from) {
            case RGB:
                return c.clone();
            case CMY:
                return new double[] {1 - c[0], 1 - c[1], 1 - c[2]};
            case CMYK:
                double left = 1 - c[3];
                return new double[] {left * (1 - c[0]), left * (1 - c[1]), left * (1 - c[2])};
            case HSV:
                double[] sixth = new double[3];
                for (int i = 0; i < 3; i++) {
                    double k = (new int[] {5, 3, 1}[i] + c[0] / 60) % 6;
                    double cut = Math.max(0, Math.min(1, Math.min(k, 4 - k)));
                    sixth[i] = c[1] == 0 ? c[2] : c[2] - c[2] * c[1] * cut;
                }
                return sixth;
            default:
                double[] round = new double[3];
                for (int i = 0; i < 3; i++) {
                    double across = c[2] == 0 ? 0 : c[2] * Math.sqrt(2 / 3.0) * Math.cos(Math.toRadians(c[0] - 120 * i));
                    round[i] = c[1] / Math.sqrt(3) + across;
                }
                return round;
        }
    }
}
