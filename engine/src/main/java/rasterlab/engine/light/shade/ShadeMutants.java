package rasterlab.engine.light.shade;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.study.Mutant;

/** Points shaded with one mistake. */
final class ShadeMutants {
    private static final FormulaShader RIGHT = new FormulaShader(Reflection.PHONG);
    private static final FormulaShader HALF_WAY = new FormulaShader(Reflection.BLINN_PHONG);

    private ShadeMutants() {}

    static List<Mutant<PointShader>> all() {
        return Stream.concat(ofTerms().stream(), ofSizes().stream()).toList();
    }

    private static List<Mutant<PointShader>> ofTerms() {
        var shared = new double[3];
        return List.of(
                new Mutant<>(
                        "sign-dropped",
                        "light-behind",
                        point ->
                                RIGHT.intensity(
                                        cosine(point) < 0
                                                ? with(point, negative(point.normal()))
                                                : point)),
                new Mutant<>(
                        "no-ambient-from-behind",
                        "light-behind-beside-ambient",
                        point ->
                                cosine(point) < 0
                                        ? point.material().emission().clone()
                                        : RIGHT.intensity(point)),
                new Mutant<>(
                        "global-ambient-weakened",
                        "global-ambient-and-distance",
                        point ->
                                RIGHT.intensity(
                                        with(
                                                point,
                                                point.light(),
                                                times(
                                                        point.globalAmbient(),
                                                        Math.min(1, factor(point)))))),
                new Mutant<>(
                        "own-ambient-not-weakened",
                        "own-ambient-and-distance",
                        ShadeMutants::ambientAnyway),
                new Mutant<>("half-vector", "facing", HALF_WAY::intensity),
                new Mutant<>(
                        "array-shared",
                        "light-behind",
                        point -> {
                            double[] right = RIGHT.intensity(point);
                            if (cosine(point) >= 0) return right;
                            System.arraycopy(right, 0, shared, 0, 3);
                            return shared;
                        }));
    }

    private static List<Mutant<PointShader>> ofSizes() {
        return List.of(
                new Mutant<>(
                        "normal-not-normalized",
                        "interpolated-normal",
                        ShadeMutants::normalAsGiven),
                new Mutant<>(
                        "cone-ignored",
                        "outside-the-cone",
                        point ->
                                RIGHT.intensity(
                                        with(
                                                point,
                                                point.light().through(SpotCone.none()),
                                                point.globalAmbient()))),
                new Mutant<>("sum-not-cut", "sum-above-1", point -> RIGHT.terms(point).sum()),
                new Mutant<>(
                        "square-overflows",
                        "huge-normal",
                        point ->
                                RIGHT.intensity(
                                        Double.isInfinite(square(point.normal()))
                                                ? withoutCosines(point)
                                                : point)),
                new Mutant<>(
                        "highlight-from-behind", "light-in-the-plane", ShadeMutants::anyHighlight),
                new Mutant<>(
                        "cosine-not-cut",
                        "light-behind-beside-ambient",
                        ShadeMutants::negativeDiffuse),
                new Mutant<>(
                        "shininess-left-out",
                        "facing",
                        point -> RIGHT.intensity(with(point, dull(point.material())))));
    }

    private static double cosine(LitPoint point) {
        double[] n = point.normal();
        double[] l = point.toLight();
        return n[0] * l[0] + n[1] * l[1] + n[2] * l[2];
    }

    private static double square(double[] n) {
        return n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    }

    private static double factor(LitPoint point) {
        return point.light().attenuation().factor(point.distance());
    }

    static double[] negative(double[] vector) {
        return times(vector, -1);
    }

    private static double[] times(double[] vector, double factor) {
        return new double[] {vector[0] * factor, vector[1] * factor, vector[2] * factor};
    }

    private static double[] ambientAnyway(LitPoint point) {
        LightSource light = point.light();
        var without =
                new LightSource(
                        new double[3],
                        light.diffuse(),
                        light.specular(),
                        light.attenuation(),
                        light.cone());
        double[] everywhere = new double[3];
        for (int c = 0; c < 3; c++) everywhere[c] = point.globalAmbient()[c] + light.ambient()[c];
        return RIGHT.intensity(with(point, without, everywhere));
    }

    /** A normal divided by infinity is 0, and so is its product with any direction. */
    private static LitPoint withoutCosines(LitPoint point) {
        LightSource light = point.light();
        var ambient =
                new LightSource(
                        light.ambient(),
                        new double[3],
                        new double[3],
                        light.attenuation(),
                        light.cone());
        return with(point, ambient, point.globalAmbient());
    }

    /** A normal that is too short or long makes the diffuse light so, which is what shows. */
    private static double[] normalAsGiven(LitPoint point) {
        double length = Math.sqrt(square(point.normal()));
        if (!(length > 0.1 && length < 10) || Math.abs(length - 1) < 1e-9)
            return RIGHT.intensity(point);
        LightSource light = point.light();
        var scaled =
                new LightSource(
                        light.ambient(),
                        times(light.diffuse(), length),
                        light.specular(),
                        light.attenuation(),
                        light.cone());
        return RIGHT.intensity(with(point, scaled, point.globalAmbient()));
    }

    static LitPoint with(LitPoint point, double[] normal) {
        return new LitPoint(
                normal,
                point.toLight(),
                point.toEye(),
                point.distance(),
                point.material(),
                point.light(),
                point.globalAmbient());
    }

    static LitPoint with(LitPoint point, LightSource light, double[] globalAmbient) {
        return new LitPoint(
                point.normal(),
                point.toLight(),
                point.toEye(),
                point.distance(),
                point.material(),
                light,
                globalAmbient);
    }

    /** Asks of a highlight alone whether r·v is above 0. */
    private static double[] anyHighlight(LitPoint point) {
        Terms terms = RIGHT.terms(point);
        if (cosine(point) > 0) return terms.intensity();
        double[] n = unit(point.normal());
        double[] l = unit(point.toLight());
        double[] v = unit(point.toEye());
        double mirrored = 2 * dot(n, l) * dot(n, v) - dot(l, v);
        double power = Math.pow(Math.max(0, mirrored), point.material().shininess());
        return changed(terms, terms.diffuse(), specular(point, terms, power)).intensity();
    }

    private static double[] negativeDiffuse(LitPoint point) {
        Terms terms = RIGHT.terms(point);
        double cosine = dot(unit(point.normal()), unit(point.toLight()));
        if (cosine >= 0) return terms.intensity();
        var diffuse = new double[3];
        for (int c = 0; c < 3; c++)
            diffuse[c] =
                    point.light().diffuse()[c]
                            * point.material().diffuse()[c]
                            * terms.attenuation()
                            * terms.cone()
                            * cosine;
        return changed(terms, diffuse, terms.specular()).intensity();
    }

    static double[] specular(LitPoint point, Terms terms, double power) {
        var specular = new double[3];
        for (int c = 0; c < 3; c++)
            specular[c] =
                    point.light().specular()[c]
                            * point.material().specular()[c]
                            * terms.attenuation()
                            * terms.cone()
                            * power;
        return specular;
    }

    static Terms changed(Terms terms, double[] diffuse, double[] specular) {
        return new Terms(
                terms.emission(),
                terms.globalAmbient(),
                terms.ambient(),
                diffuse,
                specular,
                terms.attenuation(),
                terms.cone());
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] unit(double[] vector) {
        return times(vector, 1 / Math.hypot(vector[0], Math.hypot(vector[1], vector[2])));
    }

    private static SurfaceMaterial dull(SurfaceMaterial of) {
        return new SurfaceMaterial(of.ambient(), of.diffuse(), of.specular(), of.emission(), 1);
    }

    static LitPoint with(LitPoint point, SurfaceMaterial material) {
        return new LitPoint(
                point.normal(),
                point.toLight(),
                point.toEye(),
                point.distance(),
                material,
                point.light(),
                point.globalAmbient());
    }
}
