package rasterlab.engine.light;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.UnaryOperator;
import rasterlab.contract.LightSource;
import rasterlab.contract.SurfaceMaterial;

/** Changes of a material or a light that leave something out of it or exchange it, by name. */
public final class SurfaceSlips {
    private static final double[] NONE = {0, 0, 0};
    private static final double[] WHITE = {1, 1, 1};

    /** Changes of the material. */
    public static final Map<String, UnaryOperator<SurfaceMaterial>> MATERIALS = materials();

    /** Changes of the light. */
    public static final Map<String, UnaryOperator<LightSource>> LIGHTS = lights();

    private SurfaceSlips() {}

    private static Map<String, UnaryOperator<SurfaceMaterial>> materials() {
        Map<String, UnaryOperator<SurfaceMaterial>> all = new LinkedHashMap<>();
        all.put(
                "emission-left-out",
                m -> made(m.ambient(), m.diffuse(), m.specular(), NONE, m.shininess()));
        all.put(
                "all-ambient-left-out",
                m -> made(NONE, m.diffuse(), m.specular(), m.emission(), m.shininess()));
        all.put(
                "diffuse-left-out",
                m -> made(m.ambient(), NONE, m.specular(), m.emission(), m.shininess()));
        all.put(
                "highlight-left-out",
                m -> made(m.ambient(), m.diffuse(), NONE, m.emission(), m.shininess()));
        all.put(
                "highlight-in-diffuse-colour",
                m -> made(m.ambient(), m.diffuse(), m.diffuse(), m.emission(), m.shininess()));
        all.put(
                "ambient-in-diffuse-colour",
                m -> made(m.diffuse(), m.diffuse(), m.specular(), m.emission(), m.shininess()));
        all.put(
                "exponent-left-out",
                m -> made(m.ambient(), m.diffuse(), m.specular(), m.emission(), 1));
        all.put("material-left-out", m -> made(WHITE, WHITE, WHITE, m.emission(), m.shininess()));
        return all;
    }

    private static Map<String, UnaryOperator<LightSource>> lights() {
        Map<String, UnaryOperator<LightSource>> all = new LinkedHashMap<>();
        all.put("own-ambient-left-out", l -> sent(l, NONE, l.diffuse(), l.specular()));
        all.put("light-colour-left-out", l -> sent(l, WHITE, WHITE, WHITE));
        all.put("diffuse-without-light-colour", l -> sent(l, l.ambient(), WHITE, l.specular()));
        all.put("highlight-without-light-colour", l -> sent(l, l.ambient(), l.diffuse(), WHITE));
        all.put("diffuse-light-for-highlight", l -> sent(l, l.ambient(), l.diffuse(), l.diffuse()));
        return all;
    }

    private static SurfaceMaterial made(
            double[] ambient,
            double[] diffuse,
            double[] specular,
            double[] emission,
            double shininess) {
        return new SurfaceMaterial(ambient, diffuse, specular, emission, shininess);
    }

    private static LightSource sent(
            LightSource of, double[] ambient, double[] diffuse, double[] specular) {
        return new LightSource(ambient, diffuse, specular, of.attenuation(), of.cone());
    }
}
