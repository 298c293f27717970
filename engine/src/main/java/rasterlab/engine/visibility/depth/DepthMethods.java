package rasterlab.engine.visibility.depth;

import java.util.List;
import rasterlab.contract.DepthFormat;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class DepthMethods {
    private static final String CATMULL =
            "E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974";
    private static final String AKELEY =
            "K. Akeley, J. Su, Minimum triangle separation for correct z-buffer occlusion, 2006";
    private static final String LAPIDOUS =
            "E. Lapidous, G. Jiao, Optimal depth buffer for low-cost graphics hardware, 1999";
    private static final String WINDOW = "w = (1/near − 1/z)/(1/near − 1/far)";

    private DepthMethods() {}

    static List<Method<DepthFormat>> all() {
        return List.of(
                fixed(16),
                fixed(24),
                fixed(32),
                method(
                        "zfloat",
                        WINDOW + " as a float",
                        "w from 0 to 1 grows with z",
                        "2 multiplications, 2 additions per pixel",
                        "as 24 bits; far depths lie close to 1, where floats are 2⁻²⁴ apart",
                        AKELEY,
                        new FloatDepth()),
                method(
                        "reversed-z",
                        "1 − w = (1/z − 1/far)/(1/near − 1/far) as a float",
                        "1 − w from 1 to 0 falls with z",
                        "2 multiplications, 2 additions per pixel",
                        "depths closer together than about 10⁻⁷ of z",
                        LAPIDOUS,
                        new ReversedDepth()),
                method(
                        "linear-16",
                        "(z − near)/(far − near)·(2¹⁶ − 1), rounded",
                        "equal steps of z",
                        "1 division, 2 multiplications, 2 additions per pixel",
                        "near depths closer together than far/2¹⁶; refuses an infinite far plane",
                        LAPIDOUS,
                        new LinearDepth(16)),
                incremental(16),
                incremental(24),
                method(
                        "incremental-float",
                        "w ← w + Δw in float",
                        "each sum is right but for the roundings so far",
                        "1 addition per pixel",
                        "those of zfloat; drifts on long rows",
                        CATMULL,
                        new IncrementalFloat()));
    }

    private static Method<DepthFormat> fixed(int bits) {
        return method(
                "z" + bits,
                WINDOW + ", w·(2ⁿ − 1) rounded, n = " + bits,
                "w from 0 to 1 grows with z",
                "2 multiplications, 2 additions per pixel",
                "depths closer together than z²·(1/near − 1/far)/2ⁿ",
                AKELEY,
                new FixedDepth(bits));
    }

    private static Method<DepthFormat> incremental(int bits) {
        int fraction = Integer.SIZE - bits;
        return method(
                "incremental-z" + bits,
                "sum ← sum + step, both rounded to %d bits behind the point".formatted(fraction),
                "|sum − w·(2ⁿ − 1)| ≤ (i + 1)/2^%d in pixel i, n = %d"
                        .formatted(fraction + 1, bits),
                "1 addition per pixel",
                "those of z%d; drifts on long rows".formatted(bits),
                CATMULL,
                new IncrementalFixed(bits));
    }

    private static Method<DepthFormat> method(
            String name,
            String formula,
            String invariant,
            String cost,
            String failures,
            String source,
            DepthFormat implementation) {
        return new Method<>(
                name, new About(formula, invariant, cost, failures, source), implementation);
    }
}
