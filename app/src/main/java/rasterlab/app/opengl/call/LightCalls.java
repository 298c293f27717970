package rasterlab.app.opengl.call;

import java.util.List;
import org.lwjgl.opengl.GL11;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.GlLight;
import rasterlab.app.opengl.state.GlMaterial;
import rasterlab.app.opengl.state.GlName;
import rasterlab.app.opengl.state.Setting;

/** The calls of lights and materials, before the scene is turned, so that lights stay. */
final class LightCalls {
    private final GlFrame frame;
    private final GlChoice choice;
    private final CallList calls;

    LightCalls(GlFrame frame, CallList calls) {
        this.frame = frame;
        this.calls = calls;
        choice = frame.choice();
    }

    void add() {
        GlName shading = choice.named(Setting.SHADE_MODEL);
        calls.of(Setting.SHADE_MODEL)
                .add("glShadeModel(" + shading + ")", () -> GL11.glShadeModel(shading.value()));
        calls.of(Setting.LIGHTING).enable(GlName.GL_LIGHTING, frame.lit());
        if (!frame.lit()) return;
        model();
        List<GlLight> lights = frame.lights();
        for (int i = 0; i < lights.size(); i++) light(i, lights.get(i));
        sides(GlName.GL_FRONT, Setting.FRONT_MATERIAL, frame.front());
        sides(GlName.GL_BACK, Setting.BACK_MATERIAL, frame.back());
        calls.of(Setting.SHININESS)
                .material(
                        GlName.GL_FRONT_AND_BACK,
                        GlName.GL_SHININESS,
                        choice.number(Setting.SHININESS));
        calls.of(Setting.LIGHTING);
        if (frame.colorIsMaterial())
            calls.add(
                    "glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE)",
                    () ->
                            GL11.glColorMaterial(
                                    GL11.GL_FRONT_AND_BACK, GL11.GL_AMBIENT_AND_DIFFUSE));
        calls.enable(GlName.GL_COLOR_MATERIAL, frame.colorIsMaterial());
    }

    private void model() {
        double ambient = choice.number(Setting.GLOBAL_AMBIENT);
        calls.of(Setting.GLOBAL_AMBIENT)
                .lightModel(GlName.GL_LIGHT_MODEL_AMBIENT, ambient, ambient, ambient, 1);
        calls.of(Setting.LOCAL_VIEWER)
                .lightModel(GlName.GL_LIGHT_MODEL_LOCAL_VIEWER, choice.named(Setting.LOCAL_VIEWER));
        calls.of(Setting.TWO_SIDE)
                .lightModel(GlName.GL_LIGHT_MODEL_TWO_SIDE, choice.named(Setting.TWO_SIDE));
    }

    private void light(int i, GlLight light) {
        calls.of(Setting.LIGHTS)
                .add("glEnable(GL_LIGHT" + i + ")", () -> GL11.glEnable(GL11.GL_LIGHT0 + i));
        calls.of(Setting.LIGHT_TERMS).light(i, GlName.GL_AMBIENT, opaque(light.ambient()));
        calls.light(i, GlName.GL_DIFFUSE, opaque(light.diffuse()));
        calls.light(i, GlName.GL_SPECULAR, opaque(light.specular()));
        calls.of(Setting.LIGHT_PLACE).light(i, GlName.GL_POSITION, light.position());
        calls.of(Setting.SPOT).light(i, GlName.GL_SPOT_CUTOFF, light.cutoff());
        if (light.cutoff() < 180) {
            calls.light(i, GlName.GL_SPOT_DIRECTION, light.spotDirection());
            calls.light(i, GlName.GL_SPOT_EXPONENT, light.exponent());
        }
        double[] a = light.attenuation();
        calls.of(Setting.ATTENUATION).light(i, GlName.GL_CONSTANT_ATTENUATION, a[0]);
        calls.light(i, GlName.GL_LINEAR_ATTENUATION, a[1]);
        calls.light(i, GlName.GL_QUADRATIC_ATTENUATION, a[2]);
    }

    private void sides(GlName face, Setting setting, GlMaterial material) {
        double[] diffuse = opaque(material.diffuse());
        diffuse[3] = choice.number(Setting.ALPHA);
        calls.of(setting).material(face, GlName.GL_AMBIENT, opaque(material.ambient()));
        calls.material(face, GlName.GL_DIFFUSE, diffuse);
        calls.material(face, GlName.GL_SPECULAR, opaque(material.specular()));
        calls.material(face, GlName.GL_EMISSION, opaque(material.emission()));
    }

    private static double[] opaque(double[] rgb) {
        return new double[] {rgb[0], rgb[1], rgb[2], 1};
    }
}
