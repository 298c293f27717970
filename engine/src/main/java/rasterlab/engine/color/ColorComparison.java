package rasterlab.engine.color;

import java.util.Arrays;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Deviation;

/** How far a sheet of colours is from the right one. */
final class ColorComparison {
    /** A level of a picture. */
    private static final double OUT_OF_RANGE = 1 / 255.0;

    private final ColorSheet exact;
    private final ColorSheet actual;
    private double worst;
    private String first = "";

    private ColorComparison(ColorSheet exact, ColorSheet actual) {
        this.exact = exact;
        this.actual = actual;
    }

    /**
     * The largest difference of a number from the right one. A hue's counts as the way it moves the
     * colour: its radians times the chroma, so that it means nothing next to grey; but a hue where
     * the saturation is 0, or none where it is not, is wrong altogether. One that is not from 0 to
     * below 360 is {@link #OUT_OF_RANGE} off, whatever it means.
     */
    static Deviation of(ColorSheet exact, ColorSheet actual) {
        var comparison = new ColorComparison(exact, actual);
        for (ColorModel model : ColorModel.values()) comparison.compare(model);
        return new Deviation(comparison.worst, 0, 0, exact.count(), comparison.first);
    }

    private void compare(ColorModel model) {
        double[] right = exact.in(model);
        double[] given = actual.in(model);
        if (given.length != right.length) {
            note(Double.POSITIVE_INFINITY, model, 0, Arrays.copyOf(given, model.size()));
            return;
        }
        for (int at = 0; at < right.length; at += model.size()) {
            double[] is = Arrays.copyOfRange(given, at, at + model.size());
            note(error(model, Arrays.copyOfRange(right, at, at + model.size()), is), model, at, is);
        }
    }

    private void note(double error, ColorModel model, int at, double[] is) {
        if (error > 0 && first.isEmpty())
            first =
                    "%s of colour %d is %s, right is %s"
                            .formatted(
                                    model.code(),
                                    at / model.size(),
                                    Arrays.toString(is),
                                    Arrays.toString(
                                            Arrays.copyOfRange(
                                                    exact.in(model), at, at + model.size())));
        worst = Math.max(worst, error);
    }

    private static double error(ColorModel model, double[] right, double[] is) {
        double worst = 0;
        for (int i = 0; i < right.length; i++)
            if (!model.isHue(i)) worst = Math.max(worst, difference(right[i], is[i]));
        if (model.saturation() < 0 || Double.isNaN(right[model.saturation()])) return worst;
        if (Double.isNaN(is[0]) != (is[model.saturation()] == 0)) return Double.POSITIVE_INFINITY;
        if (Double.isNaN(is[0]) || Double.isNaN(right[0])) return worst;
        if (!(is[0] >= 0 && is[0] < 360)) worst = Math.max(worst, OUT_OF_RANGE);
        double turned = Math.abs(Math.IEEEremainder(is[0] - right[0], 360));
        return Math.max(worst, Math.toRadians(turned) * chroma(model, right));
    }

    private static double chroma(ColorModel model, double[] right) {
        return model == ColorModel.HSV ? right[1] * right[2] : right[2];
    }

    private static double difference(double right, double is) {
        double error = Math.abs(right - is);
        return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
    }
}
