package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.naming.Named;
import rasterlab.engine.scene.SceneLight;

/** A scene's light as JSON: the model, lamps ("at") and suns ("from"), and one at the eye. */
final class LightJson {
    private static final double LARGEST = 1e30;

    private LightJson() {}

    static SceneLight read(SceneJsonPlace light) {
        light.object("ambient", "localViewer", "twoSided", "reflection", "lights", "atEye");
        List<Light> lights = new ArrayList<>();
        for (SceneJsonPlace one : light.at("lights").members())
            lights.add(one.made(LightJson::light));
        var model =
                new LightModel(
                        light.at("ambient").numbers(3, 0, 1),
                        light.at("localViewer").flag(),
                        light.at("twoSided").flag(),
                        light.at("reflection").made(LightJson::reflection),
                        lights);
        return new SceneLight(model, light.optional("atEye").map(LightJson::source));
    }

    private static Reflection reflection(SceneJsonPlace name) {
        return Named.find("reflection", name.text(), List.of(Reflection.values()), LightJson::code);
    }

    private static String code(Reflection reflection) {
        return reflection.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static Light light(SceneJsonPlace one) {
        one.object("at", "from", "source");
        if (one.has("at") == one.has("from"))
            throw one.wrong("must have either 'at' or 'from', the direction to a far light");
        boolean far = one.has("from");
        double[] place = one.at(far ? "from" : "at").numbers(3, -LARGEST, LARGEST);
        return new Light(source(one.at("source")), place[0], place[1], place[2], far);
    }

    private static LightSource source(SceneJsonPlace of) {
        of.object("ambient", "diffuse", "specular", "attenuation", "cone");
        return new LightSource(
                shares(of.at("ambient")),
                shares(of.at("diffuse")),
                shares(of.at("specular")),
                of.optional("attenuation")
                        .map(place -> place.made(LightJson::attenuation))
                        .orElse(Attenuation.none()),
                of.optional("cone")
                        .map(place -> place.made(LightJson::cone))
                        .orElse(SpotCone.none()));
    }

    private static double[] shares(SceneJsonPlace color) {
        return color.numbers(3, 0, LightSource.BRIGHTEST);
    }

    private static Attenuation attenuation(SceneJsonPlace of) {
        double[] factors = of.numbers(3, 0, LARGEST);
        return new Attenuation(factors[0], factors[1], factors[2]);
    }

    private static SpotCone cone(SceneJsonPlace of) {
        of.object("direction", "cutoff", "exponent");
        return new SpotCone(
                of.at("direction").numbers(3, -LARGEST, LARGEST),
                of.at("cutoff").number(0, 180),
                of.at("exponent").number(0, SpotCone.HIGHEST_EXPONENT));
    }

    static void write(SceneLight light, ObjectNode out) {
        LightModel model = light.model();
        FinishJson.putAll(out.putArray("ambient"), model.globalAmbient());
        out.put("localViewer", model.localViewer()).put("twoSided", model.twoSided());
        out.put("reflection", code(model.reflection()));
        ArrayNode lights = out.putArray("lights");
        for (Light one : model.lights()) {
            ObjectNode node = lights.addObject();
            node.putArray(one.directional() ? "from" : "at").add(one.x()).add(one.y()).add(one.z());
            write(one.source(), node.putObject("source"));
        }
        light.atEye().ifPresent(source -> write(source, out.putObject("atEye")));
    }

    private static void write(LightSource source, ObjectNode out) {
        FinishJson.putAll(out.putArray("ambient"), source.ambient());
        FinishJson.putAll(out.putArray("diffuse"), source.diffuse());
        FinishJson.putAll(out.putArray("specular"), source.specular());
        Attenuation attenuation = source.attenuation();
        out.putArray("attenuation")
                .add(attenuation.constant())
                .add(attenuation.linear())
                .add(attenuation.quadratic());
        SpotCone cone = source.cone();
        ObjectNode node = out.putObject("cone");
        FinishJson.putAll(node.putArray("direction"), cone.direction());
        node.put("cutoff", cone.cutoff()).put("exponent", cone.exponent());
    }
}
