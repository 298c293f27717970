package rasterlab.engine.color;

import rasterlab.contract.ColorModel;
import rasterlab.engine.transform.Angle;

/**
 * Red, green, blue ↔ hue, value, saturation about the grey diagonal of the colour cube.
 *
 * <p>value = (r + g + b)/√3, the distance from black to the foot of the perpendicular on the
 * diagonal. saturation = √(((r − g)² + (g − b)² + (b − r)²)/3), the perpendicular's length, which
 * as √(r² + g² + b² − value²) would lose half its digits close to grey. hue = the perpendicular's
 * angle from red: atan2(√3·(g − b), (r − g) + (r − b)).
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 7,
 * "the RGB cube" (value and saturation; of the hue it says only that it tells the nearest pure
 * colour: the angle is ours).
 */
final class GrayDiagonal {
    /** How far beyond the cube's faces rounding may lead. */
    private static final double ROUNDING = 0x1p-40;

    private static final double SQRT_2 = Math.sqrt(2);
    private static final double SQRT_3 = Math.sqrt(3);
    private static final double SQRT_6 = Math.sqrt(6);

    private GrayDiagonal() {}

    static double[] fromRgb(double[] rgb) {
        double redGreen = rgb[0] - rgb[1];
        double greenBlue = rgb[1] - rgb[2];
        double redBlue = rgb[0] - rgb[2];
        double value = (rgb[0] + rgb[1] + rgb[2]) / SQRT_3;
        if (redGreen == 0 && greenBlue == 0) return new double[] {Double.NaN, value, 0};
        // The largest difference is divided out: squares of tiny ones would underflow to 0.
        double largest =
                Math.max(Math.abs(redGreen), Math.max(Math.abs(greenBlue), Math.abs(redBlue)));
        double a = redGreen / largest;
        double b = greenBlue / largest;
        double c = redBlue / largest;
        double saturation = largest * Math.sqrt((a * a + b * b + c * c) / 3);
        double hue = Math.toDegrees(Math.atan2(SQRT_3 * b, a + c));
        return new double[] {Hue.within(hue), value, saturation};
    }

    /**
     * @throws IllegalArgumentException if the colour is outside the cube
     */
    static double[] toRgb(double[] hvs) {
        double gray = hvs[1] / SQRT_3;
        if (hvs[2] == 0) return new double[] {inside(gray, 0), inside(gray, 1), inside(gray, 2)};
        Angle hue = Angle.ofDegrees(hvs[0]);
        double along = hvs[2] * hue.cos() / SQRT_6;
        double across = hvs[2] * hue.sin() / SQRT_2;
        return new double[] {
            inside(gray + 2 * along, 0),
            inside(gray - along + across, 1),
            inside(gray - along - across, 2)
        };
    }

    private static double inside(double share, int index) {
        if (share < -ROUNDING || share > 1 + ROUNDING)
            throw new IllegalArgumentException(
                    "hvs lies outside the colour cube: its %s would be %s, allowed is 0 to 1"
                            .formatted(ColorModel.RGB.component(index), share));
        return Levels.cut(share);
    }
}
