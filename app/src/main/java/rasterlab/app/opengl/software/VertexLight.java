package rasterlab.app.opengl.software;

import java.util.List;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.GlLight;
import rasterlab.app.opengl.state.GlMaterial;
import rasterlab.app.opengl.state.Setting;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.PointLighting;

/** The light of a frame on vertices, with the engine's formula. */
final class VertexLight {
    private final PointLighting lighting;
    private final boolean colorIsMaterial;

    VertexLight(GlFrame frame) {
        GlChoice choice = frame.choice();
        double ambient = choice.number(Setting.GLOBAL_AMBIENT);
        List<Light> lights =
                frame.lights().stream().map(light -> light(light, choice.distance())).toList();
        var model =
                new LightModel(
                        new double[] {ambient, ambient, ambient},
                        choice.is(Setting.LOCAL_VIEWER, "GL_TRUE"),
                        choice.is(Setting.TWO_SIDE, "GL_TRUE"),
                        Reflection.BLINN_PHONG,
                        lights);
        lighting =
                new PointLighting(
                        model, material(frame.front(), choice), material(frame.back(), choice));
        lighting.eye(0, 0, 0, 0, 0, 1);
        colorIsMaterial = frame.colorIsMaterial();
    }

    private static Light light(GlLight light, double distance) {
        double[] at = light.position();
        double[] a = light.attenuation();
        var source =
                new LightSource(
                        light.ambient(),
                        light.diffuse(),
                        light.specular(),
                        new Attenuation(a[0], a[1], a[2]),
                        new SpotCone(light.spotDirection(), light.cutoff(), light.exponent()));
        return light.directional()
                ? Light.from(source, at[0], at[1], at[2])
                : Light.at(source, at[0], at[1], at[2] - distance);
    }

    private static Material material(GlMaterial material, GlChoice choice) {
        return new Material(
                new SurfaceMaterial(
                        material.ambient(),
                        material.diffuse(),
                        material.specular(),
                        material.emission(),
                        choice.number(Setting.SHININESS)),
                choice.number(Setting.ALPHA));
    }

    /**
     * @param eye x, y, z in eye space, then the normal's
     * @param rgba holds the vertex's own colour, receives the lit one
     */
    void shade(double[] eye, boolean behind, float[] rgba) {
        if (colorIsMaterial)
            lighting.shadeColored(eye[0], eye[1], eye[2], eye[3], eye[4], eye[5], behind, rgba, 0);
        else lighting.shade(eye[0], eye[1], eye[2], eye[3], eye[4], eye[5], behind, rgba, 0);
    }
}
