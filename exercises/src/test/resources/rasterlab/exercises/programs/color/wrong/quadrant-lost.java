import rasterlab.contract.*;

public class MyMethod implements ColorConverter {

    public double[] convert(ColorModel from, double[] c, ColorModel to) {
        double[] q = rgb(from, c);
        return write(to, q[0], q[1], q[2]);
    }

    static double[] rgb(ColorModel m, double[] c) {
        switch (m) {
            case RGB:
                return c.clone();
            case CMY:
                return new double[] {1 - c[0], 1 - c[1], 1 - c[2]};
            case CMYK:
                return new double[] {
                    (1 - c[0]) * (1 - c[3]), (1 - c[1]) * (1 - c[3]), (1 - c[2]) * (1 - c[3])
                };
            case HSV:
                {
                    double s = c[1], v = c[2];
                    if (s == 0) return new double[] {v, v, v};
                    double h = c[0] / 60;
                    if (h >= 6) h -= 6;
                    int i = (int) Math.floor(h);
                    double f = h - i,
                            p = v * (1 - s),
                            q = v * (1 - s * f),
                            t = v * (1 - s * (1 - f));
                    switch (i) {
                        case 0:
                            return new double[] {v, t, p};
                        case 1:
                            return new double[] {q, v, p};
                        case 2:
                            return new double[] {p, v, t};
                        case 3:
                            return new double[] {p, q, v};
                        case 4:
                            return new double[] {t, p, v};
                        default:
                            return new double[] {v, p, q};
                    }
                }
            default:
                {
                    double v = c[1] / Math.sqrt(3);
                    if (c[2] == 0) return new double[] {v, v, v};
                    double[] o = new double[3];
                    for (int k = 0; k < 3; k++)
                        o[k] =
                                v
                                        + c[2]
                                                * Math.sqrt(2.0 / 3)
                                                * Math.cos(Math.toRadians(c[0] - 120 * k));
                    return o;
                }
        }
    }

    static double[] write(ColorModel m, double r, double g, double b) {
        double M = Math.max(r, Math.max(g, b)), n = Math.min(r, Math.min(g, b));
        switch (m) {
            case RGB:
                return new double[] {r, g, b};
            case CMY:
                return new double[] {1 - r, 1 - g, 1 - b};
            case CMYK:
                return M == 0
                        ? new double[] {0, 0, 0, 1}
                        : new double[] {(M - r) / M, (M - g) / M, (M - b) / M, 1 - M};
            case HSV:
                {
                    if (M == n) return new double[] {Double.NaN, 0, M};
                    double h =
                            M == r
                                    ? (g - b) / (M - n)
                                    : M == g ? 2 + (b - r) / (M - n) : 4 + (r - g) / (M - n);
                    h *= 60;
                    if (h < 0) h += 360;
                    if (h >= 360) h -= 360;
                    return new double[] {h, (M - n) / M, M};
                }
            default:
                {
                    double v = (r + g + b) / Math.sqrt(3),
                            s =
                                    Math.sqrt(
                                            ((r - g) * (r - g)
                                                            + (g - b) * (g - b)
                                                            + (b - r) * (b - r))
                                                    / 3);
                    if (M == n) return new double[] {Double.NaN, v, 0};
                    double h = Math.toDegrees(Math.atan(Math.sqrt(3) * (g - b) / (2 * r - g - b)));
                    if (h < 0) h += 360;
                    if (h >= 360) h -= 360;
                    return new double[] {h, v, s};
                }
        }
    }
}
