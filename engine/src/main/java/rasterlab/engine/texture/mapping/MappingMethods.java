package rasterlab.engine.texture.mapping;

import java.util.List;
import rasterlab.contract.TextureMapper;
import rasterlab.contract.TexturedSpan;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class MappingMethods {
    private static final String HECKBERT =
            "P. S. Heckbert, H. P. Moreton, Interpolation for polygon texture mapping and shading,"
                    + " 1991";

    private MappingMethods() {}

    static List<Method<TextureMapper>> all() {
        return List.of(
                method(
                        "affine",
                        "s = (1 − f)·s₀ + f·s₁",
                        "equal steps of s and t",
                        "5 multiplications per pixel, 7 divisions per row",
                        "every face that is not parallel to the picture",
                        new AffineMapper(TexturedSpan.MOST_PIXELS)),
                method(
                        "affine-16",
                        "perspective at every 16th pixel, affine between",
                        "right at the ends of each piece",
                        "5 multiplications per pixel, 7 divisions per 16",
                        "faces that reach close to the eye",
                        new AffineMapper(16)),
                method(
                        "stepped-float",
                        "s/d, t/d, 1/d ← + their steps, in float; s = (s/d)/(1/d)",
                        "each sum is right but for the roundings so far",
                        "3 additions, 2 divisions per pixel",
                        "drifts on long rows and where 1/d falls to little",
                        new SteppedMapper()),
                method(
                        "perspective",
                        "s = ((1 − f)·d₁·s₀ + f·d₀·s₁)/((1 − f)·d₁ + f·d₀)",
                        "s lies between s₀ and s₁, but for rounding",
                        "6 multiplications, 3 divisions per pixel",
                        "none known",
                        new PerspectiveMapper()));
    }

    private static Method<TextureMapper> method(
            String name,
            String formula,
            String invariant,
            String cost,
            String failures,
            TextureMapper implementation) {
        return new Method<>(
                name, new About(formula, invariant, cost, failures, HECKBERT), implementation);
    }
}
