package rasterlab.engine.color;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import rasterlab.contract.ColorModel;
import rasterlab.engine.transform.exact.BigTrig;

/**
 * The models by their definitions, in decimals of 60 digits.
 *
 * <p>A colour out of range has no model: all its numbers are NaN.
 */
final class ExactColors {
    private static final MathContext DIGITS = BigTrig.DIGITS;
    private static final BigDecimal ONE = BigDecimal.ONE;
    private static final BigDecimal THREE = BigDecimal.valueOf(3);
    private static final BigDecimal SIXTY = BigDecimal.valueOf(60);
    private static final BigDecimal ROOT_3 = THREE.sqrt(DIGITS);
    private static final BigDecimal ROUNDING = new BigDecimal(0x1p-40);

    private ExactColors() {}

    static double[] convert(ColorModel from, double[] components, ColorModel to) {
        boolean gray = from.saturation() >= 0 && components[from.saturation()] == 0;
        for (int i = 0; i < components.length; i++)
            if (!(gray && from.isHue(i)) && !Components.inRange(from, i, components[i]))
                return none(to);
        BigDecimal[] rgb = toRgb(from, components, gray);
        for (int i = 0; i < 3; i++) {
            if (rgb[i].compareTo(ROUNDING.negate()) < 0 || rgb[i].compareTo(ONE.add(ROUNDING)) > 0)
                return none(to);
            rgb[i] = rgb[i].max(BigDecimal.ZERO).min(ONE);
        }
        return fromRgb(rgb, to);
    }

    private static double[] none(ColorModel to) {
        var none = new double[to.size()];
        Arrays.fill(none, Double.NaN);
        return none;
    }

    private static BigDecimal[] toRgb(ColorModel from, double[] components, boolean gray) {
        var given = new BigDecimal[components.length];
        for (int i = 0; i < given.length; i++)
            given[i] = gray && from.isHue(i) ? BigDecimal.ZERO : new BigDecimal(components[i]);
        return switch (from) {
            case RGB -> given;
            case CMY -> less(ONE, given, ONE);
            case CMYK -> less(ONE, given, ONE.subtract(given[3]));
            case HSV -> fromHexcone(given[0], given[1], given[2]);
            case HVS -> fromDiagonal(given[0], given[1], given[2]);
        };
    }

    /** (from − given[i])·factor for the first three. */
    private static BigDecimal[] less(BigDecimal from, BigDecimal[] given, BigDecimal factor) {
        var less = new BigDecimal[3];
        for (int i = 0; i < 3; i++) less[i] = from.subtract(given[i]).multiply(factor);
        return less;
    }

    /** v − v·s·max(0, min(k, 4 − k, 1)) with k = (n + h/60) mod 6 and n = 5, 3, 1. */
    private static BigDecimal[] fromHexcone(BigDecimal h, BigDecimal s, BigDecimal v) {
        var rgb = new BigDecimal[3];
        for (int i = 0; i < 3; i++) {
            BigDecimal k =
                    h.divide(SIXTY, DIGITS)
                            .add(BigDecimal.valueOf(5 - 2L * i))
                            .remainder(BigDecimal.valueOf(6));
            BigDecimal share =
                    k.min(BigDecimal.valueOf(4).subtract(k)).min(ONE).max(BigDecimal.ZERO);
            rgb[i] = v.subtract(v.multiply(s).multiply(share));
        }
        return rgb;
    }

    /** v/√3 + s·√(2/3)·cos(h − 120°·i). */
    private static BigDecimal[] fromDiagonal(BigDecimal h, BigDecimal v, BigDecimal s) {
        var rgb = new BigDecimal[3];
        BigDecimal reach = s.multiply(BigDecimal.valueOf(2).divide(THREE, DIGITS).sqrt(DIGITS));
        for (int i = 0; i < 3; i++) {
            BigDecimal cos = BigTrig.ofDegrees(h.subtract(BigDecimal.valueOf(120L * i))).cos();
            rgb[i] = v.divide(ROOT_3, DIGITS).add(reach.multiply(cos));
        }
        return rgb;
    }

    private static double[] fromRgb(BigDecimal[] rgb, ColorModel to) {
        BigDecimal max = rgb[0].max(rgb[1]).max(rgb[2]);
        return switch (to) {
            case RGB -> doubles(rgb);
            case CMY -> doubles(less(ONE, rgb, ONE));
            case CMYK -> cmyk(rgb, max);
            case HSV -> hexcone(rgb, max);
            case HVS -> diagonal(rgb);
        };
    }

    private static double[] cmyk(BigDecimal[] rgb, BigDecimal max) {
        if (max.signum() == 0) return new double[] {0, 0, 0, 1};
        double[] inks = doubles(less(max, rgb, ONE.divide(max, DIGITS)));
        return new double[] {inks[0], inks[1], inks[2], ONE.subtract(max).doubleValue()};
    }

    private static double[] hexcone(BigDecimal[] rgb, BigDecimal max) {
        BigDecimal chroma = max.subtract(rgb[0].min(rgb[1]).min(rgb[2]));
        if (chroma.signum() == 0) return new double[] {Double.NaN, 0, max.doubleValue()};
        int k = 0;
        while (rgb[k].compareTo(max) < 0) k++;
        BigDecimal sixths =
                rgb[(k + 1) % 3]
                        .subtract(rgb[(k + 2) % 3])
                        .divide(chroma, DIGITS)
                        .add(BigDecimal.valueOf(2L * k + 6))
                        .remainder(BigDecimal.valueOf(6));
        return new double[] {
            sixths.multiply(SIXTY).doubleValue(),
            chroma.divide(max, DIGITS).doubleValue(),
            max.doubleValue()
        };
    }

    private static double[] diagonal(BigDecimal[] rgb) {
        BigDecimal sum = rgb[0].add(rgb[1]).add(rgb[2]);
        BigDecimal squares = BigDecimal.ZERO;
        for (BigDecimal share : rgb) squares = squares.add(share.multiply(share));
        BigDecimal off = squares.subtract(sum.multiply(sum).divide(THREE, new MathContext(2000)));
        double value = sum.divide(ROOT_3, DIGITS).doubleValue();
        boolean gray = rgb[0].compareTo(rgb[1]) == 0 && rgb[1].compareTo(rgb[2]) == 0;
        if (gray) return new double[] {Double.NaN, value, 0};
        BigDecimal across = ROOT_3.multiply(rgb[1].subtract(rgb[2]));
        BigDecimal along = rgb[0].add(rgb[0]).subtract(rgb[1]).subtract(rgb[2]);
        return new double[] {
            angle(along, across), value, off.round(DIGITS).sqrt(DIGITS).doubleValue()
        };
    }

    /**
     * The angle of (x, y) in degrees, 0 to below 360: a rough one by doubles, then one step towards
     * the place where y·cos − x·sin = 0, with an exact sine and cosine of the rough one.
     */
    private static double angle(BigDecimal x, BigDecimal y) {
        BigDecimal largest = x.abs().max(y.abs());
        double rough =
                Math.toDegrees(
                        Math.atan2(
                                y.divide(largest, DIGITS).doubleValue(),
                                x.divide(largest, DIGITS).doubleValue()));
        BigTrig at = BigTrig.ofDegrees(rough);
        BigDecimal off = y.multiply(at.cos()).subtract(x.multiply(at.sin()));
        BigDecimal length = x.multiply(at.cos()).add(y.multiply(at.sin()));
        double rest = Math.toDegrees(off.divide(length, DIGITS).doubleValue());
        double degrees =
                new BigDecimal(rough)
                        .add(new BigDecimal(rest))
                        .add(rough + rest < 0 ? BigDecimal.valueOf(360) : BigDecimal.ZERO)
                        .doubleValue();
        return degrees == 360 ? 0 : degrees;
    }

    private static double[] doubles(BigDecimal[] values) {
        return Arrays.stream(values).mapToDouble(BigDecimal::doubleValue).toArray();
    }
}
