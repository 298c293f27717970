package rasterlab.engine.texture.mapping;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Mutant;

/** Texture coordinates along a row with one mistake. */
final class MappingMutants {
    private static final TextureMapper RIGHT = new PerspectiveMapper();

    private MappingMutants() {}

    static List<Mutant<TextureMapper>> all() {
        return List.of(
                new Mutant<>("s-t-linear", "floor", new AffineTextbookMapper()),
                new Mutant<>("depth-linear", "at-the-near-plane", MappingMutants::linearDepth),
                new Mutant<>("divided-by-n", "both-ends", MappingMutants::byN),
                new Mutant<>(
                        "s-t-swapped",
                        "s-is-not-t",
                        span -> {
                            double[] st = RIGHT.coordinates(span);
                            for (int i = 0; i < st.length; i += 2) {
                                double s = st[i];
                                st[i] = st[i + 1];
                                st[i + 1] = s;
                            }
                            return st;
                        }),
                new Mutant<>(
                        "single-pixel-divides-by-0",
                        "single-pixel",
                        span ->
                                span.pixels() == 1
                                        ? new double[] {Double.NaN, Double.NaN}
                                        : RIGHT.coordinates(span)),
                new Mutant<>("sums-in-float", "long-row", new SteppedMapper()),
                new Mutant<>("not-divided-back", "floor", MappingMutants::overDepth),
                new Mutant<>(
                        "share-in-whole-numbers",
                        "floor",
                        span -> at(span, pixel -> pixel == span.pixels() - 1 ? pixel : 0)),
                new Mutant<>(
                        "half-a-pixel-on",
                        "both-ends",
                        span ->
                                at(
                                        span,
                                        pixel ->
                                                (pixel + 0.5)
                                                        * (span.pixels() - 1)
                                                        / span.pixels())),
                new Mutant<>(
                        "brought-into-the-picture",
                        "both-ends",
                        span ->
                                Arrays.stream(RIGHT.coordinates(span))
                                        .map(each -> each - Math.floor(each))
                                        .toArray()));
    }

    private static double share(TexturedSpan span, int pixel) {
        return span.pixels() == 1 ? 0 : pixel / (span.pixels() - 1.0);
    }

    private static double[] linearDepth(TexturedSpan span) {
        var st = new double[2 * span.pixels()];
        for (int i = 0; i < span.pixels(); i++) {
            double f = share(span, i);
            double depth = (1 - f) * span.fromDepth() + f * span.toDepth();
            double from = (1 - f) / span.fromDepth() * depth;
            double to = f / span.toDepth() * depth;
            st[2 * i] = from * span.fromS() + to * span.toS();
            st[2 * i + 1] = from * span.fromT() + to * span.toT();
        }
        return st;
    }

    private static double[] byN(TexturedSpan span) {
        if (span.pixels() == 1 || span.pixels() == TexturedSpan.MOST_PIXELS)
            return RIGHT.coordinates(span);
        double[] longer =
                RIGHT.coordinates(
                        new TexturedSpan(
                                span.fromS(),
                                span.fromT(),
                                span.fromDepth(),
                                span.toS(),
                                span.toT(),
                                span.toDepth(),
                                span.pixels() + 1));
        return Arrays.copyOf(longer, 2 * span.pixels());
    }

    /** s/d and t/d where s and t are asked for. */
    private static double[] overDepth(TexturedSpan span) {
        double[] st = RIGHT.coordinates(span);
        for (int i = 0; i < span.pixels(); i++) {
            double f = share(span, i);
            double inverse = (1 - f) / span.fromDepth() + f / span.toDepth();
            st[2 * i] *= inverse;
            st[2 * i + 1] *= inverse;
        }
        return st;
    }

    /** Looks at other places along the row. */
    private static double[] at(TexturedSpan span, IntToDoubleFunction place) {
        var st = new double[2 * span.pixels()];
        for (int i = 0; i < span.pixels(); i++) {
            double f = span.pixels() == 1 ? 0 : place.applyAsDouble(i) / (span.pixels() - 1);
            double from = (1 - f) * span.toDepth();
            double to = f * span.fromDepth();
            st[2 * i] = (from * span.fromS() + to * span.toS()) / (from + to);
            st[2 * i + 1] = (from * span.fromT() + to * span.toT()) / (from + to);
        }
        return st;
    }
}
