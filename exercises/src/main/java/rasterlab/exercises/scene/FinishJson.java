package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Appearance;

/** The JSON form of the look of faces: a material, or one for the front and one for the back. */
final class FinishJson {
    private FinishJson() {}

    static Appearance read(SceneJsonPlace finish) {
        if (!finish.has("front")) return Appearance.of(material(finish));
        finish.object("front", "back");
        return new Appearance(
                material(finish.at("front")), material(finish.at("back")), Optional.empty());
    }

    private static Material material(SceneJsonPlace of) {
        of.object("ambient", "diffuse", "specular", "emission", "shininess", "alpha");
        double[] diffuse = of.at("diffuse").numbers(3, 0, 1);
        var surface =
                new SurfaceMaterial(
                        of.optional("ambient").map(FinishJson::shares).orElse(diffuse),
                        diffuse,
                        of.optional("specular").map(FinishJson::shares).orElse(new double[3]),
                        of.optional("emission").map(FinishJson::shares).orElse(new double[3]),
                        of.optional("shininess")
                                .map(p -> p.number(0, SurfaceMaterial.HIGHEST_SHININESS))
                                .orElse(0.0));
        return new Material(surface, of.optional("alpha").map(p -> p.number(0, 1)).orElse(1.0));
    }

    private static double[] shares(SceneJsonPlace color) {
        return color.numbers(3, 0, 1);
    }

    static void write(Appearance finish, ObjectNode out) {
        if (finish.back() == finish.front()) write(finish.front(), out);
        else {
            write(finish.front(), out.putObject("front"));
            write(finish.back(), out.putObject("back"));
        }
    }

    private static void write(Material material, ObjectNode out) {
        SurfaceMaterial surface = material.surface();
        putAll(out.putArray("ambient"), surface.ambient());
        putAll(out.putArray("diffuse"), surface.diffuse());
        putAll(out.putArray("specular"), surface.specular());
        putAll(out.putArray("emission"), surface.emission());
        out.put("shininess", surface.shininess()).put("alpha", material.alpha());
    }

    static void putAll(ArrayNode out, double[] numbers) {
        for (double number : numbers) out.add(number);
    }
}
