package rasterlab.engine.light.shade;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;

class ShadePropertyTest {
    private static final ShadeTopic TOPIC = new ShadeTopic();

    @Property(tries = 700)
    void everyMethodIsExact(@ForAll long seed) {
        LitPoint point = point(new Random(seed));
        if (almostOpposite(point)) return;
        var points = new LitPoints(List.of(point));
        Shades exact = TOPIC.exact(points, 1);
        for (Method<PointShader> method : TOPIC.methods()) {
            if (method.faulty()) continue;
            Shades actual = TOPIC.record(method.implementation(), points, 1);
            Deviation deviation = TOPIC.compare(points, exact, actual);
            assertTrue(TOPIC.correct(deviation), () -> method.name() + " " + deviation);
        }
    }

    @Property(tries = 700)
    void pipelinesFormulaIsTheTopics(@ForAll long seed) {
        var random = new Random(seed);
        LitPoint point = point(random);
        if (almostOpposite(point)) return;
        double[] at = random.doubles(3, -2, 2).toArray();
        for (Reflection reflection : Reflection.values()) {
            double[] right = new FormulaShader(reflection).intensity(point);
            PointLighting lighting = lighting(point, at, reflection);
            var rgba = new float[5];
            double[] n = point.normal();
            lighting.shade(at[0], at[1], at[2], n[0], n[1], n[2], false, rgba, 1);
            double[] shades = {rgba[1], rgba[2], rgba[3]};
            assertArrayEquals(right, shades, 1e-6, reflection.name());
        }
    }

    /** The point put at {@code at}, with its light and its eye around it. */
    private static PointLighting lighting(LitPoint point, double[] at, Reflection reflection) {
        double[] l = scaled(point.toLight(), point.distance(), at);
        double[] v = scaled(point.toEye(), 1, at);
        var light = Light.at(point.light(), l[0], l[1], l[2]);
        var model = new LightModel(point.globalAmbient(), true, false, reflection, List.of(light));
        var material = new Material(point.material(), 1);
        var lighting = new PointLighting(model, material, material);
        lighting.eye(v[0], v[1], v[2], 0, 0, 1);
        return lighting.forThread();
    }

    private static double[] scaled(double[] direction, double length, double[] from) {
        double scale = length / length(direction);
        return new double[] {
            from[0] + scale * direction[0],
            from[1] + scale * direction[1],
            from[2] + scale * direction[2]
        };
    }

    private static LitPoint point(Random random) {
        var material =
                new SurfaceMaterial(
                        random.doubles(3).toArray(),
                        random.doubles(3).toArray(),
                        random.doubles(3).toArray(),
                        random.doubles(3, 0, 0.2).toArray(),
                        random.nextBoolean()
                                ? random.nextInt(201)
                                : random.nextDouble(0, SurfaceMaterial.HIGHEST_SHININESS));
        var cone =
                random.nextBoolean()
                        ? SpotCone.none()
                        : new SpotCone(
                                direction(random),
                                random.nextDouble(0, 90),
                                random.nextDouble(0, 128));
        var light =
                new LightSource(
                        random.doubles(3, 0, 0.2).toArray(),
                        random.doubles(3, 0, 2).toArray(),
                        random.doubles(3, 0, 2).toArray(),
                        new Attenuation(
                                random.nextDouble(0.1, 1),
                                random.nextDouble(),
                                random.nextDouble()),
                        cone);
        return new LitPoint(
                direction(random),
                direction(random),
                direction(random),
                random.nextDouble(0.1, 3),
                material,
                light,
                random.doubles(3, 0, 0.3).toArray());
    }

    private static double[] direction(Random random) {
        return random.doubles(3, -1, 1).map(x -> x + Math.copySign(1e-3, x)).toArray();
    }

    /** Where h has no more digits: that is the hazard eye-opposite-the-light. */
    private static boolean almostOpposite(LitPoint point) {
        double[] l = point.toLight();
        double[] v = point.toEye();
        double cosine = (l[0] * v[0] + l[1] * v[1] + l[2] * v[2]) / length(l) / length(v);
        return cosine < -0.999;
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
