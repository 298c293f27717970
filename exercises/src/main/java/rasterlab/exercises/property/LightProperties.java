package rasterlab.exercises.property;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.Shades;

/**
 * Properties of light at surfaces: no more leaves a point than comes there, and what comes from
 * everywhere is never taken away. Both assume a light that distance does not make brighter.
 */
final class LightProperties {
    static final List<Property<?, ?>> ALL =
            List.of(
                    new Property<LitPoints, Shades>(
                            "shade",
                            "energy-bound",
                            points -> points.points().stream().allMatch(one -> fades(one.light())),
                            Relation.kept(LightProperties::bounded)),
                    new Property<FacePoints, double[]>(
                            "shade-face",
                            "energy-bound",
                            points -> fades(points.face().light()),
                            Relation.kept(LightProperties::bounded)));

    private LightProperties() {}

    private static boolean fades(LightSource light) {
        return light.attenuation().constant() >= 1;
    }

    private static double bounded(
            double value,
            int color,
            SurfaceMaterial material,
            LightSource light,
            double[] globalAmbient) {
        double least =
                material.emission()[color] + globalAmbient[color] * material.ambient()[color];
        double most =
                least
                        + light.ambient()[color] * material.ambient()[color]
                        + light.diffuse()[color] * material.diffuse()[color]
                        + light.specular()[color] * material.specular()[color];
        return Math.max(Math.min(1, least), Math.min(Math.min(1, most), value));
    }

    private static Shades bounded(LitPoints points, Shades answer) {
        Map<Reflection, double[]> all = new EnumMap<>(Reflection.class);
        answer.rgb()
                .forEach(
                        (reflection, shares) -> {
                            double[] bounded = shares.clone();
                            for (int i = 0; i < bounded.length; i++) {
                                LitPoint point = points.points().get(i / 3);
                                bounded[i] =
                                        bounded(
                                                shares[i],
                                                i % 3,
                                                point.material(),
                                                point.light(),
                                                point.globalAmbient());
                            }
                            all.put(reflection, bounded);
                        });
        return new Shades(all);
    }

    private static double[] bounded(FacePoints points, double[] answer) {
        double[] bounded = answer.clone();
        for (int i = 0; i < bounded.length; i++)
            bounded[i] =
                    bounded(
                            answer[i],
                            i % 3,
                            points.face().material(),
                            points.face().light(),
                            points.face().globalAmbient());
        return bounded;
    }
}
