package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** Depth buffers by what they store. */
final class DepthBufferMethods {
    private static final String CATMULL = "E. Catmull, PhD thesis, University of Utah, 1974";
    private static final String INVARIANT =
            "each pixel holds the nearest of the faces drawn so far";

    private DepthBufferMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                fixed(16, 16),
                fixed(24, 8),
                fixed(32, 16),
                new Method<>(
                        "zfloat",
                        new About(
                                "nearness = ρ / z, linear over a plane in pixel coordinates; the"
                                        + " larger wins",
                                INVARIANT,
                                "one comparison per pixel of every face",
                                "faces closer together than a float can tell; faces in one plane",
                                CATMULL),
                        new ZBuffer(range -> new NearnessCodes())),
                new Method<>(
                        "reversed-z",
                        new About(
                                "(1/z − 1/far) / (1/near − 1/far) as a float, 1 at the near plane;"
                                        + " the larger wins",
                                INVARIANT,
                                "one comparison per pixel of every face",
                                "faces closer together than about 10⁻⁷ of z; faces in one plane",
                                CATMULL + "; the reversal is common practice"),
                        new ZBuffer(ReversedCodes::new)));
    }

    private static Method<Visibility> fixed(int bits, int fraction) {
        return new Method<>(
                "z" + bits,
                new About(
                        "(1/near − 1/z) / (1/near − 1/far) in %d bits, one addition per pixel; the"
                                        .formatted(bits)
                                + " smaller wins",
                        INVARIANT,
                        "one addition and one comparison per pixel of every face",
                        "depths closer together than z²·(1/near − 1/far) / 2^%d; the sum drifts by"
                                        .formatted(bits)
                                + " up to p / 2^%d codes in p pixels".formatted(fraction + 1),
                        CATMULL),
                new ZBuffer(range -> new FixedCodes(bits, fraction, range)));
    }
}
