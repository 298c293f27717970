package rasterlab.engine.pipeline;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.scene.Scene;

/**
 * The cheapest shading that shows what a scene has.
 *
 * <p>Flat where corners have no normals of their own: the faces are meant to be flat. Otherwise
 * Gouraud's, unless it would lose something inside faces: highlights or the rim of a spot light.
 * Otherwise Phong's.
 */
final class AutoShading {
    private AutoShading() {}

    static Choice of(Scene scene, Set<LightTerm> terms) {
        if (!scene.mesh().hasNormals())
            return choice(ShadingMethod.FLAT, "corners have no normals of their own");
        if (terms.contains(LightTerm.SPECULAR) && shines(scene))
            return choice(ShadingMethod.PHONG, "highlights would be lost between corners");
        if (lights(scene).anyMatch(light -> !light.cone().shinesAllAround()))
            return choice(ShadingMethod.PHONG, "a spot light's rim would be lost between corners");
        return choice(ShadingMethod.GOURAUD, "no highlights and no spot lights");
    }

    private static Choice choice(ShadingMethod method, String reason) {
        return new Choice(method.code(), reason);
    }

    private static boolean shines(Scene scene) {
        return scene.light().model().reflection() != Reflection.LAMBERT
                && lights(scene).anyMatch(light -> any(light.specular()))
                && scene.finishes().stream()
                        .flatMap(finish -> Stream.of(finish.front(), finish.back()))
                        .anyMatch(material -> any(material.surface().specular()));
    }

    private static Stream<LightSource> lights(Scene scene) {
        List<Light> standing = scene.light().model().lights();
        return Stream.concat(standing.stream().map(Light::source), scene.light().atEye().stream());
    }

    private static boolean any(double[] shares) {
        return shares[0] > 0 || shares[1] > 0 || shares[2] > 0;
    }
}
