package rasterlab.engine.texture.mapping;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Slip;

/** Texture coordinates along a row by a mistaken depth or share. */
final class MappingSlips {
    private MappingSlips() {}

    static List<Slip<TextureMapper>> of(TextureMapper right) {
        return List.of(
                Slip.of("depth-of-one-end", by(Ends.FIRST), by(Ends.LAST)),
                Slip.of(
                        "one-coordinate-linear",
                        span -> one(right.coordinates(span), linear(span), 0),
                        span -> one(right.coordinates(span), linear(span), 1)),
                Slip.of("multiplied-by-depth", by(Ends.MULTIPLIED)),
                Slip.of("divided-by-n-plus-1", span -> stretched(right, span, span.pixels() + 2)),
                Slip.of("last-pixel-left-out", span -> all(right, span, -2)),
                Slip.of("depth-of-the-ends-swapped", span -> right.coordinates(swapped(span))));
    }

    private enum Ends {
        FIRST,
        LAST,
        MULTIPLIED
    }

    private static TextureMapper by(Ends ends) {
        return span -> coordinates(span, ends);
    }

    private static double[] coordinates(TexturedSpan span, Ends ends) {
        var out = new double[2 * span.pixels()];
        double near = span.fromDepth();
        double far = span.toDepth();
        for (int i = 0; i < span.pixels(); i++) {
            double share = span.pixels() == 1 ? 0 : i / (span.pixels() - 1.0);
            boolean times = ends == Ends.MULTIPLIED;
            double first = times ? near : 1 / near;
            double last = times ? far : 1 / far;
            double depth =
                    switch (ends) {
                        case FIRST -> near;
                        case LAST -> far;
                        case MULTIPLIED -> 1 / mix(1 / near, 1 / far, share);
                    };
            double back = times ? 1 / mix(1 / near, 1 / far, share) : depth;
            out[2 * i] = mix(span.fromS() * first, span.toS() * last, share) * back;
            out[2 * i + 1] = mix(span.fromT() * first, span.toT() * last, share) * back;
        }
        return out;
    }

    private static double mix(double a, double b, double share) {
        return (1 - share) * a + share * b;
    }

    private static double[] linear(TexturedSpan span) {
        var out = new double[2 * span.pixels()];
        for (int i = 0; i < span.pixels(); i++) {
            double share = span.pixels() == 1 ? 0 : i / (span.pixels() - 1.0);
            out[2 * i] = mix(span.fromS(), span.toS(), share);
            out[2 * i + 1] = mix(span.fromT(), span.toT(), share);
        }
        return out;
    }

    private static double[] one(double[] right, double[] linear, int coordinate) {
        double[] out = right.clone();
        for (int i = coordinate; i < out.length; i += 2) out[i] = linear[i];
        return out;
    }

    /** The first pixels of a row of more between the same ends. */
    private static double[] stretched(TextureMapper right, TexturedSpan span, int pixels) {
        var longer = with(span, span.fromDepth(), span.toDepth(), pixels);
        return Arrays.copyOf(right.coordinates(longer), 2 * span.pixels());
    }

    private static double[] all(TextureMapper right, TexturedSpan span, int more) {
        double[] out = right.coordinates(span).clone();
        Arrays.fill(out, out.length + more, out.length, 0);
        return out;
    }

    private static TexturedSpan swapped(TexturedSpan span) {
        return with(span, span.toDepth(), span.fromDepth(), span.pixels());
    }

    private static TexturedSpan with(TexturedSpan span, double from, double to, int pixels) {
        return new TexturedSpan(
                span.fromS(), span.fromT(), from, span.toS(), span.toT(), to, pixels);
    }
}
