package rasterlab.engine.texture.mapping;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.Images;

/**
 * Texture coordinates along a row.
 *
 * <p>The error is the largest difference of s or t, in texels of a picture of 256×256. Up to 10⁻⁹
 * count as exact: coordinates up to 1000 in double. Coordinates are usable within half a texel.
 */
public final class MappingTopic implements Topic<TextureMapper, TexturedSpan, Images> {
    private static final double CORRECT = 1e-9;
    private static final double USABLE = 0.5;
    private static final double TEXELS = 256;
    private static final MathContext DIGITS = new MathContext(60);

    @Override
    public String name() {
        return "texture-mapping";
    }

    @Override
    public String lab() {
        return "light";
    }

    @Override
    public Class<TextureMapper> contract() {
        return TextureMapper.class;
    }

    @Override
    public List<Method<TextureMapper>> methods() {
        return MappingMethods.all();
    }

    @Override
    public List<Hazard<TexturedSpan>> hazards() {
        return MappingHazards.all();
    }

    @Override
    public List<Workload<TexturedSpan>> workloads() {
        return List.of(floor(16), floor(128), floor(1024));
    }

    @Override
    public List<Mutant<TextureMapper>> mutants() {
        return MappingMutants.all();
    }

    @Override
    public List<Slip<TextureMapper>> slips(TextureMapper right) {
        return MappingSlips.of(right);
    }

    /** A row down a floor, from 2 to 12 units away. */
    private static Workload<TexturedSpan> floor(int pixels) {
        return new Workload<>(
                "pixels-" + pixels,
                pixels,
                List.of(new TexturedSpan(0.1, 0, 2, 0.7, 4, 12, pixels)));
    }

    @Override
    public Images run(TextureMapper method, TexturedSpan span, int limit) {
        double[] st = method.coordinates(span);
        WrongLength.require(2 * span.pixels(), st.length, "numbers");
        return new Images(st, 2).first(limit);
    }

    @Override
    public long spend(TextureMapper method, TexturedSpan span) {
        return method.coordinates(span).length / 2;
    }

    @Override
    public Images exact(TexturedSpan span, int limit) {
        int count = Math.min(limit, span.pixels());
        var st = new double[2 * count];
        for (int i = 0; i < count; i++) {
            BigDecimal to = BigDecimal.valueOf(span.pixels() == 1 ? 0 : i);
            BigDecimal from = BigDecimal.valueOf(Math.max(1, span.pixels() - 1)).subtract(to);
            BigDecimal a = from.divide(new BigDecimal(span.fromDepth()), DIGITS);
            BigDecimal b = to.divide(new BigDecimal(span.toDepth()), DIGITS);
            st[2 * i] = mean(a, span.fromS(), b, span.toS());
            st[2 * i + 1] = mean(a, span.fromT(), b, span.toT());
        }
        return new Images(st, 2);
    }

    private static double mean(BigDecimal a, double x, BigDecimal b, double y) {
        return a.multiply(new BigDecimal(x))
                .add(b.multiply(new BigDecimal(y)))
                .divide(a.add(b), DIGITS)
                .doubleValue();
    }

    @Override
    public Deviation compare(TexturedSpan span, Images exact, Images actual) {
        var scales = new double[exact.size()];
        Arrays.fill(scales, 1 / TEXELS);
        return exact.deviation(actual, scales);
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
    public Map<String, Long> operations(TextureMapper method, TexturedSpan span) {
        return method instanceof CountedMapper counted ? counted.operations(span) : Map.of();
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "texels";
    }

    @Override
    public Format<TextureMapper, TexturedSpan, Images> format() {
        return new MappingFormat(this);
    }
}
