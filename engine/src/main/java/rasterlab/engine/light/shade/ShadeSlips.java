package rasterlab.engine.light.shade;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.SurfaceSlips;
import rasterlab.engine.study.Slip;

/** Points lit with something left out, taken for something else or the wrong way round. */
final class ShadeSlips {
    private static final FormulaShader FORMULA = new FormulaShader(Reflection.PHONG);

    private ShadeSlips() {}

    static List<Slip<PointShader>> of(PointShader right) {
        List<Slip<PointShader>> all = new ArrayList<>();
        SurfaceSlips.MATERIALS.forEach(
                (name, change) -> all.add(lit(name, right, point -> material(point, change))));
        SurfaceSlips.LIGHTS.forEach(
                (name, change) -> all.add(lit(name, right, point -> light(point, change))));
        all.add(lit("global-ambient-left-out", right, point -> everywhere(point, new double[3])));
        all.addAll(ofDirections(right));
        all.addAll(ofTheCone(right));
        return all;
    }

    private static List<Slip<PointShader>> ofDirections(PointShader right) {
        return List.of(
                lit(
                        "normal-turned-round",
                        right,
                        point -> ShadeMutants.with(point, ShadeMutants.negative(point.normal()))),
                Slip.of("mirrored-the-wrong-way", point -> shone(point, -1, false)),
                Slip.of("highlight-times-cosine", point -> shone(point, 1, true)),
                lit(
                        "light-and-eye-swapped",
                        right,
                        point ->
                                new LitPoint(
                                        point.normal(),
                                        point.toEye(),
                                        point.toLight(),
                                        point.distance(),
                                        point.material(),
                                        point.light(),
                                        point.globalAmbient())));
    }

    private static List<Slip<PointShader>> ofTheCone(PointShader right) {
        return List.of(
                lit(
                        "cone-not-dimmed",
                        right,
                        point -> cone(point, point.light().cone().direction(), 0)),
                lit(
                        "cone-the-wrong-way",
                        right,
                        point ->
                                cone(
                                        point,
                                        ShadeMutants.negative(point.light().cone().direction()),
                                        point.light().cone().exponent())),
                lit(
                        "attenuation-left-out",
                        right,
                        point -> light(point, one -> one.attenuated(Attenuation.none()))));
    }

    private static Slip<PointShader> lit(
            String name, PointShader right, UnaryOperator<LitPoint> change) {
        return Slip.of(name, point -> right.intensity(change.apply(point)));
    }

    private static LitPoint material(LitPoint point, UnaryOperator<SurfaceMaterial> change) {
        return new LitPoint(
                point.normal(),
                point.toLight(),
                point.toEye(),
                point.distance(),
                change.apply(point.material()),
                point.light(),
                point.globalAmbient());
    }

    private static LitPoint light(LitPoint point, UnaryOperator<LightSource> change) {
        return ShadeMutants.with(point, change.apply(point.light()), point.globalAmbient());
    }

    private static LitPoint everywhere(LitPoint point, double[] globalAmbient) {
        return ShadeMutants.with(point, point.light(), globalAmbient);
    }

    private static LitPoint cone(LitPoint point, double[] direction, double exponent) {
        SpotCone cone = point.light().cone();
        return cone.shinesAllAround()
                ? point
                : light(
                        point,
                        one -> one.through(new SpotCone(direction, cone.cutoff(), exponent)));
    }

    /**
     * The light with another highlight.
     *
     * @param way 1 for the mirrored direction, −1 for its opposite
     * @param weaker whether it is multiplied by n·l, as the diffuse term is
     */
    private static double[] shone(LitPoint point, int way, boolean weaker) {
        Terms terms = FORMULA.terms(point);
        double[] n = ShadeMutants.unit(point.normal());
        double[] l = ShadeMutants.unit(point.toLight());
        double[] v = ShadeMutants.unit(point.toEye());
        double cosine = ShadeMutants.dot(n, l);
        if (cosine <= 0) return terms.intensity();
        double mirrored = 2 * cosine * ShadeMutants.dot(n, v) - ShadeMutants.dot(l, v);
        double power = Math.pow(Math.max(0, way * mirrored), point.material().shininess());
        double[] specular = ShadeMutants.specular(point, terms, weaker ? cosine * power : power);
        return ShadeMutants.changed(terms, terms.diffuse(), specular).intensity();
    }
}
