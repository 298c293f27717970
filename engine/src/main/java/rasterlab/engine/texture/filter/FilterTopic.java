package rasterlab.engine.texture.filter;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.study.WrongLength;

/**
 * Colours of pixels that show a picture.
 *
 * <p>An output is alpha, red, green and blue of each pixel, 0 to 255. The error is the largest
 * difference in levels. Up to half a level counts as exact, since colours are whole levels. An
 * output is usable within 8 levels.
 */
public final class FilterTopic implements Topic<TextureFilter, FilteredPixels, double[]> {
    private static final double CORRECT = 0.5 + 1e-6;
    private static final double USABLE = 8;
    private static final long SEED = 1983;

    @Override
    public String name() {
        return "texture-filter";
    }

    @Override
    public String lab() {
        return "light";
    }

    @Override
    public Class<TextureFilter> contract() {
        return TextureFilter.class;
    }

    @Override
    public List<Method<TextureFilter>> methods() {
        return FilterMethods.all();
    }

    @Override
    public List<Hazard<FilteredPixels>> hazards() {
        return FilterHazards.all();
    }

    /** Pictures of noise made smaller by 1, 4 and 16; the size is the number of pixels. */
    @Override
    public List<Workload<FilteredPixels>> workloads() {
        var workloads = new ArrayList<Workload<FilteredPixels>>();
        for (int pixels : new int[] {64, 256, 1024}) {
            var random = new Random(SEED);
            int[] argb = random.ints(64 * 64).map(level -> level | 0xFF000000).toArray();
            var footprints = new double[pixels * FilteredPixels.NUMBERS];
            for (int i = 0; i < footprints.length; i += FilteredPixels.NUMBERS) {
                footprints[i] = random.nextDouble();
                footprints[i + 1] = random.nextDouble();
                footprints[i + 2] = random.nextDouble(1, 16) / 64;
                footprints[i + 5] = random.nextDouble(1, 16) / 64;
            }
            workloads.add(
                    new Workload<>(
                            "pixels-" + pixels,
                            pixels,
                            List.of(new FilteredPixels(64, 64, argb, footprints))));
        }
        return workloads;
    }

    @Override
    public List<Mutant<TextureFilter>> mutants() {
        return FilterMutants.all();
    }

    @Override
    public List<Slip<TextureFilter>> slips(TextureFilter right) {
        return FilterSlips.of(right);
    }

    @Override
    public List<Mutant<TextureFilter>> mutants(String method) {
        return switch (method) {
            case "linear" -> LookupMutants.linear();
            case "trilinear" -> LookupMutants.trilinear();
            default -> mutants();
        };
    }

    @Override
    public double[] run(TextureFilter method, FilteredPixels pixels, int limit) {
        int count = Math.min(limit, pixels.count());
        double[] footprints = pixels.footprints();
        if (count < pixels.count())
            footprints = Arrays.copyOf(footprints, count * FilteredPixels.NUMBERS);
        int[] colors = method.colors(pixels.width(), pixels.height(), pixels.argb(), footprints);
        WrongLength.require(count, colors.length, "colours");
        var levels = new double[4 * count];
        for (int i = 0; i < count; i++)
            for (int c = 0; c < 4; c++) levels[4 * i + c] = colors[i] >>> 24 - 8 * c & 255;
        return levels;
    }

    /** The time of the method with that to make the picture ready, spread over the pixels. */
    @Override
    public long spend(TextureFilter method, FilteredPixels pixels) {
        return method.colors(pixels.width(), pixels.height(), pixels.argb(), pixels.footprints())
                .length;
    }

    @Override
    public double[] exact(FilteredPixels pixels, int limit) {
        var exact = new ExactFootprint(pixels);
        var levels = new double[4 * Math.min(limit, pixels.count())];
        for (int i = 0; i < levels.length / 4; i++)
            System.arraycopy(exact.mean(i), 0, levels, 4 * i, 4);
        return levels;
    }

    @Override
    public Deviation compare(FilteredPixels pixels, double[] exact, double[] actual) {
        double worst = 0;
        String first = "";
        for (int i = 0; i < exact.length; i += 4) {
            double error = 0;
            for (int c = i; c < i + 4; c++) error = Math.max(error, Math.abs(exact[c] - actual[c]));
            if (error > CORRECT && first.isEmpty())
                first =
                        "pixel %d is %s, right is %s"
                                .formatted(i / 4, text(actual, i), text(exact, i));
            worst = Math.max(worst, error);
        }
        return new Deviation(worst, 0, 0, exact.length / 4, first);
    }

    private static String text(double[] levels, int at) {
        return Arrays.toString(Arrays.copyOfRange(levels, at, at + 4));
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    /** Texels looked up, and colours mixed two at a time: one less than texels of each pixel. */
    @Override
    public Map<String, Long> operations(TextureFilter method, FilteredPixels pixels) {
        if (!(method instanceof SteppedFilter stepped)) return Map.of();
        long texels = stepped.texels(pixels).stream().mapToLong(List::size).sum();
        return Map.of("texels", texels, "mixes", texels - pixels.count());
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "levels";
    }

    @Override
    public Format<TextureFilter, FilteredPixels, double[]> format() {
        return new FilterFormat(this);
    }
}
