package rasterlab.engine.color;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.SharedAnswer;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.study.WrongLength;

/**
 * Writing colours in all models.
 *
 * <p>Shares are of the order of 1, and so is the error's unit. Up to 16·2⁻⁵³ counts as exact: a few
 * rounded operations each. An output is usable within 4 of 255 levels, which half a 256th of a turn
 * of hue is below.
 */
public final class ColorTopic implements Topic<ColorConverter, Colors, ColorSheet> {
    private static final double CORRECT = 16 * 0x1p-53;
    private static final double USABLE = 4.0 / Levels.HIGHEST;

    @Override
    public String name() {
        return "color";
    }

    @Override
    public String lab() {
        return "light";
    }

    @Override
    public Class<ColorConverter> contract() {
        return ColorConverter.class;
    }

    @Override
    public List<Method<ColorConverter>> methods() {
        return ColorMethods.all();
    }

    @Override
    public List<Hazard<Colors>> hazards() {
        return ColorHazards.all();
    }

    @Override
    public List<Workload<Colors>> workloads() {
        return ColorWorkloads.all();
    }

    @Override
    public List<Mutant<ColorConverter>> mutants() {
        return ColorMutants.all();
    }

    @Override
    public List<Slip<ColorConverter>> slips(ColorConverter right) {
        return ColorSlips.of(right);
    }

    @Override
    public Map<String, String> vocabulary() {
        var words = new LinkedHashMap<String, String>();
        for (ColorModel model : ColorModel.values()) words.put(model.code(), meaning(model));
        return words;
    }

    private static String meaning(ColorModel model) {
        var names = new StringBuilder();
        for (int i = 0; i < model.size(); i++)
            names.append(i == 0 ? "" : ", ").append(model.component(i));
        return names.toString();
    }

    @Override
    public ColorSheet run(ColorConverter method, Colors colors, int limit) {
        return sheet(method, colors, Math.min(limit, colors.count()));
    }

    private static ColorSheet sheet(ColorConverter method, Colors colors, int count) {
        var models = new EnumMap<ColorModel, double[]>(ColorModel.class);
        for (ColorModel to : ColorModel.values()) {
            var all = new double[count * to.size()];
            for (int i = 0; i < count; i++) {
                double[] given = colors.color(i);
                double[] one = method.convert(colors.model(), given, to);
                double[] again = method.convert(colors.model(), colors.color(i), to);
                SharedAnswer.requireNew(one, given, again);
                WrongLength.require(to.size(), one.length, "numbers of " + to.code());
                System.arraycopy(one, 0, all, i * to.size(), to.size());
            }
            models.put(to, all);
        }
        return new ColorSheet(models);
    }

    /** The number of colours, each written in all models. */
    @Override
    public long spend(ColorConverter method, Colors colors) {
        long numbers = 0;
        for (int i = 0; i < colors.count(); i++) {
            double[] color = colors.color(i);
            for (ColorModel to : ColorModel.values())
                numbers += method.convert(colors.model(), color, to).length;
        }
        return numbers > 0 ? colors.count() : 0;
    }

    @Override
    public ColorSheet exact(Colors colors, int limit) {
        return sheet(ExactColors::convert, colors, Math.min(limit, colors.count()));
    }

    @Override
    public Deviation compare(Colors colors, ColorSheet exact, ColorSheet actual) {
        return ColorComparison.of(exact, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    @Override
    public String item() {
        return "colour in all models";
    }

    @Override
    public String errorUnit() {
        return "of full share";
    }

    @Override
    public Format<ColorConverter, Colors, ColorSheet> format() {
        return new ColorFormat(this);
    }
}
