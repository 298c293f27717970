package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.light.shade.Shades;
import rasterlab.engine.light.shade.TermShader;
import rasterlab.engine.light.shade.Terms;
import rasterlab.engine.light.shade.Terms.Addition;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code shade}: a point with its directions, material and light; {@code intensity} and the
 * {@code terms} it is the sum of out.
 */
final class ShadeRun implements TopicRun {
    private static final JsonField<double[]> NORMAL = LightJson.vector("normal");
    private static final JsonField<double[]> TO_LIGHT = LightJson.vector("to-light");
    private static final JsonField<double[]> TO_EYE = LightJson.vector("to-eye");
    private static final JsonField<Double> DISTANCE =
            JsonField.optional("distance", json -> json.numberFrom(0, Double.MAX_VALUE));

    private final Topic<PointShader, LitPoints, Shades> topic = new ShadeTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ShadeRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"normal":[x,y,z], "to-light":[x,y,z], "to-eye":[x,y,z], "material":M, \
                "light":L, "distance":d, "global-ambient":C}, the last three being optional;"""
                        + " "
                        + LightJson.FORM
                        + """
                ; L's own ambient light is weakened by its distance as the rest of L is, \
                1/(c + l·d + q·d²), global-ambient is not""",
                """
                {"intensity":[r,g,b], "terms":{"emission":[r,g,b], "global-ambient":[...], \
                "ambient":[...], "diffuse":[...], "specular":[...], "attenuation":f, "cone":f}}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        LitPoint point =
                point(
                        StrictJson.object(
                                text,
                                length,
                                NORMAL,
                                TO_LIGHT,
                                TO_EYE,
                                LightJson.MATERIAL,
                                LightJson.LIGHT,
                                DISTANCE,
                                LightJson.GLOBAL_AMBIENT));
        PointShader shader = topic.method(method).implementation();
        double[] intensity = watch.call(method, () -> shader.intensity(point));
        List<Terms> terms = watch.call(method, () -> terms(shader, point));
        if (steps && terms.isEmpty()) throw Steps.none(method);
        return json -> {
            json.writeFieldName("intensity");
            JsonNumbers.write(json, intensity);
            for (Terms each : terms) {
                write(json, each);
                if (steps) Steps.write(json, steps(each, intensity), ShadeRun::write);
            }
        };
    }

    /** The terms one by one, and the cut where there is something to cut. */
    private static List<Addition> steps(Terms terms, double[] intensity) {
        List<Addition> steps = terms.additions();
        if (!Arrays.equals(terms.sum(), intensity))
            steps.add(new Addition("cut to [0, 1]", intensity, intensity));
        return steps;
    }

    private static void write(JsonGenerator json, Addition step) throws IOException {
        json.writeStringField("step", step.term());
        write(json, "value", step.value());
        write(json, "sum", step.sum());
    }

    private static List<Terms> terms(PointShader shader, LitPoint point) {
        return shader instanceof TermShader termed ? List.of(termed.terms(point)) : List.of();
    }

    /** Without a distance the light stands where {@code to-light} ends. */
    private static LitPoint point(Given given) {
        double[] toLight = given.get(TO_LIGHT);
        try {
            return new LitPoint(
                    given.get(NORMAL),
                    toLight,
                    given.get(TO_EYE),
                    given.find(DISTANCE).orElseGet(() -> UnitVector.length(toLight)),
                    given.get(LightJson.MATERIAL),
                    LightJson.light(given),
                    LightJson.globalAmbient(given));
        } catch (IllegalArgumentException e) {
            throw EngineRefusal.complaint(e);
        }
    }

    private static void write(JsonGenerator json, Terms terms) throws IOException {
        json.writeObjectFieldStart("terms");
        write(json, "emission", terms.emission());
        write(json, "global-ambient", terms.globalAmbient());
        write(json, "ambient", terms.ambient());
        write(json, "diffuse", terms.diffuse());
        write(json, "specular", terms.specular());
        JsonNumbers.writeField(json, "attenuation", terms.attenuation());
        JsonNumbers.writeField(json, "cone", terms.cone());
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, String name, double[] rgb) throws IOException {
        json.writeFieldName(name);
        JsonNumbers.write(json, rgb);
    }
}
