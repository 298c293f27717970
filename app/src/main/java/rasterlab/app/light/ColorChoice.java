package rasterlab.app.light;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.color.Colors;
import rasterlab.engine.color.FormulaColors;
import rasterlab.engine.study.NoAnswer;

/**
 * A colour, as it was written last, and how its cube is turned.
 *
 * @param model in which it was written
 * @param components its numbers there
 * @param method whose round trips are shown
 * @param yaw of the cube about the vertical, radians
 * @param pitch of the cube towards the eye, radians
 * @param outside whether the last number tried would have left the cube
 */
public record ColorChoice(
        ColorModel model,
        List<Double> components,
        String method,
        double yaw,
        double pitch,
        boolean outside) {
    private static final int HALVINGS = 40;

    public ColorChoice {
        components = List.copyOf(components);
    }

    public static ColorChoice first() {
        return new ColorChoice(
                ColorModel.RGB, List.of(0.85, 0.45, 0.2), "formula", 0.62, 0.42, false);
    }

    /**
     * This colour with another number; a colour outside the cube is not taken.
     *
     * @param in the model whose number it is
     */
    public ColorChoice with(ColorModel in, int index, double value) {
        double[] numbers = in(in);
        if (Double.isNaN(numbers[0])) numbers[0] = 0;
        numbers[index] = value;
        try {
            new FormulaColors().convert(in, numbers, ColorModel.RGB);
        } catch (IllegalArgumentException e) {
            return new ColorChoice(model, components, method, yaw, pitch, true);
        }
        return new ColorChoice(in, list(numbers), method, yaw, pitch, false);
    }

    /**
     * The first of those colours, as it is written; one outside the cube is brought into it, with
     * its hue and value if those are in range.
     *
     * @param byMethod whose round trips are shown
     */
    ColorChoice with(Colors colors, String byMethod) {
        ColorModel in = colors.model();
        double[] numbers = Arrays.copyOf(colors.components(), in.size());
        boolean whole = inside(in, numbers);
        if (!whole) {
            for (int i = 0; i < numbers.length; i++)
                numbers[i] = Math.max(0, Math.min(in.highest(i), numbers[i]));
            paled(in, numbers);
        }
        return new ColorChoice(in, list(numbers), byMethod, yaw, pitch, !whole);
    }

    private static boolean inside(ColorModel in, double[] numbers) {
        try {
            new FormulaColors().convert(in, numbers, ColorModel.RGB);
            return true;
        } catch (IllegalArgumentException outside) {
            return false;
        }
    }

    /** Takes from the last number, a saturation, what leaves the cube: a grey is always in it. */
    private static void paled(ColorModel in, double[] numbers) {
        if (inside(in, numbers)) return;
        int last = numbers.length - 1;
        double out = numbers[last];
        double least = 0;
        for (int halving = 0; halving < HALVINGS; halving++) {
            numbers[last] = (least + out) / 2;
            if (inside(in, numbers)) least = numbers[last];
            else out = numbers[last];
        }
        numbers[last] = least;
    }

    public ColorChoice withMethod(String name) {
        return new ColorChoice(model, components, name, yaw, pitch, outside);
    }

    /** The choice turned; the cube never stands on its head. */
    public ColorChoice turned(double right, double down) {
        double tilted = Math.max(-1.4, Math.min(1.4, pitch + down));
        return new ColorChoice(model, components, method, yaw + right, tilted, outside);
    }

    /** The numbers in a model; those it was written in as they were written. */
    public double[] in(ColorModel other) {
        double[] own = components.stream().mapToDouble(Double::doubleValue).toArray();
        return other == model ? own : new FormulaColors().convert(model, own, other);
    }

    /** The colour as 0xRRGGBB. */
    public int rgb() {
        double[] rgb = in(ColorModel.RGB);
        int value = 0;
        for (double share : rgb) value = value << 8 | (int) Math.round(255 * share);
        return value;
    }

    /**
     * How far red, green and blue come back from each model, by the chosen method: the largest
     * difference; NaN where it refuses or gives no number.
     */
    public Map<ColorModel, Double> roundTrips() {
        return roundTrips(new ColorTopic().method(method).implementation());
    }

    /**
     * The difference that comes back from each model by any method.
     *
     * @throws NoAnswer if the method runs elsewhere and gives none
     */
    Map<ColorModel, Double> roundTrips(ColorConverter converter) {
        var errors = new EnumMap<ColorModel, Double>(ColorModel.class);
        double[] rgb = in(ColorModel.RGB);
        for (ColorModel each : ColorModel.values())
            if (each != ColorModel.RGB) errors.put(each, error(converter, rgb, each));
        return errors;
    }

    private static double error(ColorConverter converter, double[] rgb, ColorModel by) {
        try {
            double[] there = converter.convert(ColorModel.RGB, rgb, by);
            double[] back = converter.convert(by, there, ColorModel.RGB);
            double worst = 0;
            for (int c = 0; c < 3; c++) worst = Math.max(worst, Math.abs(back[c] - rgb[c]));
            for (double share : back) if (Double.isNaN(share)) return Double.NaN;
            return worst;
        } catch (NoAnswer none) {
            throw none;
        } catch (IllegalArgumentException refused) {
            return Double.NaN; // What the table says of such a method.
        }
    }

    private static List<Double> list(double[] numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }
}
