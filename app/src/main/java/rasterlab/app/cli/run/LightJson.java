package rasterlab.app.cli.run;

import java.io.IOException;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;

/** Materials and lights as JSON; a colour is an array of three shares or one number for all. */
final class LightJson {
    /** What M, L and C stand for in a topic's form. */
    static final String FORM =
            """
            M = {"ambient":C, "diffuse":C, "specular":C, "emission":C, "shininess":n}, L = \
            {"ambient":C, "diffuse":C, "specular":C, "attenuation":[c,l,q], "spot":\
            {"direction":[x,y,z], "cutoff":degrees, "exponent":e}}, each field of M and L being \
            optional, C = [r,g,b] or one number for all three""";

    static final JsonField<SurfaceMaterial> MATERIAL =
            JsonField.required("material", json -> json.checked(LightJson::material));
    static final JsonField<LightSource> LIGHT =
            JsonField.optional("light", json -> json.checked(LightJson::light));
    static final JsonField<double[]> GLOBAL_AMBIENT =
            colour("global-ambient", LightSource.BRIGHTEST);

    private static final JsonField<double[]> AMBIENT = colour("ambient", LightSource.BRIGHTEST);
    private static final JsonField<double[]> DIFFUSE = colour("diffuse", LightSource.BRIGHTEST);
    private static final JsonField<double[]> SPECULAR = colour("specular", LightSource.BRIGHTEST);
    private static final JsonField<double[]> EMISSION = colour("emission", 1);
    private static final JsonField<Double> SHININESS =
            JsonField.optional(
                    "shininess", json -> json.numberFrom(0, SurfaceMaterial.HIGHEST_SHININESS));
    private static final JsonField<Attenuation> ATTENUATION =
            JsonField.optional("attenuation", json -> json.checked(LightJson::attenuation));
    private static final JsonField<SpotCone> SPOT =
            JsonField.optional("spot", json -> json.checked(LightJson::spot));
    private static final JsonField<double[]> DIRECTION = vector("direction");
    private static final JsonField<Double> CUTOFF =
            JsonField.required("cutoff", StrictJson::number);
    private static final JsonField<Double> EXPONENT =
            JsonField.optional("exponent", StrictJson::number);

    private LightJson() {}

    /** A field of three numbers. */
    static JsonField<double[]> vector(String name) {
        return JsonField.required(name, json -> json.numbers(3, 3));
    }

    private static JsonField<double[]> colour(String name, double highest) {
        return JsonField.optional(name, json -> shares(json, highest));
    }

    private static double[] shares(StrictJson json, double highest) throws IOException {
        if (json.startsArray()) return json.numbers(3, 3);
        double grey = json.numberFrom(0, highest);
        return new double[] {grey, grey, grey};
    }

    /** The light of {@code given}, white where there is none. */
    static LightSource light(Given given) {
        return given.find(LIGHT).orElseGet(LightSource::white);
    }

    /** The light from everywhere of {@code given}, none where there is none. */
    static double[] globalAmbient(Given given) {
        return given.find(GLOBAL_AMBIENT).orElse(new double[3]);
    }

    private static SurfaceMaterial material(StrictJson json) throws IOException {
        Given given = json.object(AMBIENT, DIFFUSE, SPECULAR, EMISSION, SHININESS);
        return new SurfaceMaterial(
                given.find(AMBIENT).orElse(new double[3]),
                given.find(DIFFUSE).orElse(new double[3]),
                given.find(SPECULAR).orElse(new double[3]),
                given.find(EMISSION).orElse(new double[3]),
                given.find(SHININESS).orElse(0.0));
    }

    private static LightSource light(StrictJson json) throws IOException {
        Given given = json.object(AMBIENT, DIFFUSE, SPECULAR, ATTENUATION, SPOT);
        LightSource white = LightSource.white();
        return new LightSource(
                given.find(AMBIENT).orElse(white.ambient()),
                given.find(DIFFUSE).orElse(white.diffuse()),
                given.find(SPECULAR).orElse(white.specular()),
                given.find(ATTENUATION).orElse(white.attenuation()),
                given.find(SPOT).orElse(white.cone()));
    }

    private static Attenuation attenuation(StrictJson json) throws IOException {
        double[] terms = json.numbers(3, 3);
        return new Attenuation(terms[0], terms[1], terms[2]);
    }

    private static SpotCone spot(StrictJson json) throws IOException {
        Given given = json.object(DIRECTION, CUTOFF, EXPONENT);
        return new SpotCone(
                given.get(DIRECTION), given.get(CUTOFF), given.find(EXPONENT).orElse(0.0));
    }
}
