package rasterlab.engine.color;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Slip;

/** Colours converted by a formula that is mistaken in one place. */
final class ColorSlips {
    private ColorSlips() {}

    static List<Slip<ColorConverter>> of(ColorConverter right) {
        return Stream.of(ofHues(right), ofSaturationAndValue(right), ofInks(right))
                .flatMap(List::stream)
                .toList();
    }

    private static List<Slip<ColorConverter>> ofHues(ColorConverter right) {
        return List.of(
                Slip.of(
                        "hue-in-turns",
                        after(right, ColorModel.HSV, (rgb, hsv) -> hsv[0] /= 360),
                        after(right, ColorModel.HVS, (rgb, hvs) -> hvs[0] /= 360)),
                Slip.of(
                        "sectors-exchanged",
                        after(right, ColorModel.HSV, ColorSlips::exchangeSectors)),
                Slip.of(
                        "p-q-t-exchanged",
                        (from, components, to) ->
                                right.convert(
                                        from,
                                        from == ColorModel.HSV ? mirrored(components) : components,
                                        to)),
                Slip.of(
                        "quadrant-lost",
                        after(right, ColorModel.HVS, (rgb, hvs) -> hvs[0] = byTangent(rgb))),
                Slip.of(
                        "root-of-3-left-out-of-hue",
                        after(
                                right,
                                ColorModel.HVS,
                                (rgb, hvs) ->
                                        hvs[0] =
                                                hue(
                                                        rgb[1] - rgb[2],
                                                        2 * rgb[0] - rgb[1] - rgb[2]))));
    }

    private static List<Slip<ColorConverter>> ofSaturationAndValue(ColorConverter right) {
        return List.of(
                Slip.of(
                        "value-is-lightness",
                        after(
                                right,
                                ColorModel.HSV,
                                (rgb, hsv) -> hsv[2] = (largest(rgb) + smallest(rgb)) / 2)),
                Slip.of(
                        "value-is-smallest",
                        after(right, ColorModel.HSV, (rgb, hsv) -> hsv[2] = smallest(rgb))),
                Slip.of(
                        "saturation-by-the-sum",
                        after(
                                right,
                                ColorModel.HSV,
                                (rgb, hsv) ->
                                        hsv[1] =
                                                (largest(rgb) - smallest(rgb))
                                                        / (largest(rgb) + smallest(rgb)))),
                Slip.of(
                        "value-is-the-third",
                        after(
                                right,
                                ColorModel.HVS,
                                (rgb, hvs) -> hvs[1] = (rgb[0] + rgb[1] + rgb[2]) / 3)),
                Slip.of(
                        "saturation-and-value-exchanged",
                        after(right, ColorModel.HSV, (rgb, hsv) -> swap(hsv)),
                        after(right, ColorModel.HVS, (rgb, hvs) -> swap(hvs))));
    }

    private static List<Slip<ColorConverter>> ofInks(ColorConverter right) {
        return List.of(
                Slip.of(
                        "inks-not-taken-from-1",
                        after(right, ColorModel.CMY, (rgb, cmy) -> copy(rgb, cmy)),
                        (from, components, to) ->
                                from == ColorModel.CMY
                                        ? right.convert(ColorModel.RGB, components, to)
                                        : right.convert(from, components, to),
                        (from, components, to) ->
                                right.convert(
                                        from == ColorModel.CMY ? ColorModel.RGB : from,
                                        components,
                                        to == ColorModel.CMY ? ColorModel.RGB : to)),
                Slip.of(
                        "black-is-the-brightest",
                        after(right, ColorModel.CMYK, (rgb, cmyk) -> cmyk[3] = largest(rgb))),
                Slip.of(
                        "black-ignored",
                        (from, components, to) ->
                                from == ColorModel.CMYK
                                        ? right.convert(
                                                ColorModel.CMY,
                                                new double[] {
                                                    components[0], components[1], components[2]
                                                },
                                                to)
                                        : right.convert(from, components, to)),
                Slip.of(
                        "black-by-the-darkest",
                        after(right, ColorModel.CMYK, (rgb, k) -> dark(k, rgb))),
                Slip.of("levels-to-255", bytes(right, ColorModel.RGB), bytes(right, null)));
    }

    private interface Adjusted {
        void by(double[] rgb, double[] answer);
    }

    /** Changes the answer in one model. */
    private static ColorConverter after(ColorConverter right, ColorModel model, Adjusted adjusted) {
        return (from, components, to) -> {
            double[] answer = right.convert(from, components, to).clone();
            if (to == model) adjusted.by(right.convert(from, components, ColorModel.RGB), answer);
            return answer;
        };
    }

    /** Multiplies by 255 the shares of one model, or of all that have but shares. */
    private static ColorConverter bytes(ColorConverter right, ColorModel model) {
        return (from, components, to) -> {
            double[] answer = right.convert(from, components, to).clone();
            boolean shares = to != ColorModel.HSV && to != ColorModel.HVS;
            if (model == null ? shares : to == model)
                for (int i = 0; i < answer.length; i++) answer[i] *= 255;
            return answer;
        };
    }

    private static void exchangeSectors(double[] rgb, double[] hsv) {
        if (Double.isNaN(hsv[0]) || rgb[0] == largest(rgb)) return;
        hsv[0] = (hsv[0] + (rgb[1] == largest(rgb) ? 120 : 240)) % 360;
    }

    /** The colour as far from the end of its sector as the given one is from its beginning. */
    private static double[] mirrored(double[] hsv) {
        double sixths = hsv[0] % 360 / 60;
        double sector = Math.floor(sixths);
        double[] other = hsv.clone();
        if (!Double.isNaN(hsv[0])) other[0] = 60 * (sector + 1 - (sixths - sector));
        return other;
    }

    private static double byTangent(double[] rgb) {
        double across = Math.sqrt(3) * (rgb[1] - rgb[2]);
        double along = 2 * rgb[0] - rgb[1] - rgb[2];
        double degrees = Math.toDegrees(Math.atan(across / along));
        return degrees < 0 ? degrees + 360 : degrees;
    }

    private static double hue(double across, double along) {
        if (across == 0 && along == 0) return Double.NaN;
        double degrees = Math.toDegrees(Math.atan2(across, along));
        return degrees < 0 ? degrees + 360 : degrees;
    }

    /** Takes the smallest share for the black that the brightest leaves. */
    private static void dark(double[] cmyk, double[] rgb) {
        double black = 1 - smallest(rgb);
        cmyk[3] = black;
        for (int i = 0; i < 3; i++) cmyk[i] = (1 - rgb[i] - black) / (1 - black);
    }

    private static void copy(double[] from, double[] to) {
        System.arraycopy(from, 0, to, 0, from.length);
    }

    private static void swap(double[] answer) {
        double second = answer[1];
        answer[1] = answer[2];
        answer[2] = second;
    }

    private static double largest(double[] rgb) {
        return Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
    }

    private static double smallest(double[] rgb) {
        return Math.min(rgb[0], Math.min(rgb[1], rgb[2]));
    }
}
