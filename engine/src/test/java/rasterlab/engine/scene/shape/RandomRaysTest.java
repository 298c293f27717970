package rasterlab.engine.scene.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.math.BigDecimal;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Rays against equations without rounding; 5,000 with {@code -Drasterlab.full=true}. */
class RandomRaysTest {
    private static final int RAYS = Boolean.getBoolean("rasterlab.full") ? 5_000 : 100;
    private static final int STEPS = 300;

    /** World units about a place found in which the exact place lies, where the ray is no graze. */
    private static final double SURE = 1e-12;

    static Stream<Arguments> equations() {
        return Stream.of(
                argumentSet("sphere", new Sphere(2), -3.0, 3.0),
                argumentSet("tube", Cylinder.open(1.2, 4), -2.0, 2.0),
                argumentSet("torus", new Torus(2, 0.7), -3.0, 3.0),
                argumentSet("nearly closed torus", new Torus(1.3, 1.25), -3.0, 3.0),
                argumentSet("thin torus", new Torus(2, 0.05), -3.0, 3.0),
                argumentSet("spindle", Shapes.spindle(), -1.0, 2.0));
    }

    /** A step along the ray that changes sides has met the surface; before it nothing may be. */
    @ParameterizedTest(name = "a ray passes through the {argumentSetName}")
    @MethodSource("equations")
    void noSideChangesBefore(SceneShape shape, double low, double high) {
        var ray = new Ray();
        for (int seed = 0; seed < RAYS; seed++) {
            double[] line = line(new Random(seed));
            aim(ray, line);
            shape.meet(ray);
            double end = Math.min(ray.t() * (1 - SURE) - SURE, 12);
            int before = 0;
            for (int k = 0; k <= STEPS; k++) {
                BigDecimal t = new BigDecimal(end * k / STEPS);
                double z = line[2] + t.doubleValue() * line[5];
                boolean there = z > low + SURE && z < high - SURE;
                int side = there ? ExactSide.of(shape, line, t) : 0;
                assertTrue(side * before >= 0, "seed %d, before t = %s".formatted(seed, t));
                before = side;
            }
        }
    }

    @ParameterizedTest(name = "the place on the {argumentSetName} is off by more than its bound")
    @MethodSource("equations")
    void theSideChangesThere(SceneShape shape, double low, double high) {
        var ray = new Ray();
        int met = 0;
        for (int seed = 0; seed < RAYS; seed++) {
            double[] line = line(new Random(seed));
            aim(ray, line);
            shape.meet(ray);
            if (ray.t() == Double.POSITIVE_INFINITY || grazes(ray)) continue;
            met++;
            var sure = new BigDecimal(SURE / length(ray));
            int before = ExactSide.of(shape, line, new BigDecimal(ray.t()).subtract(sure));
            int after = ExactSide.of(shape, line, new BigDecimal(ray.t()).add(sure));
            int expected = ray.fromInside() ? 1 : -1;
            assertEquals(expected, after, "seed " + seed);
            assertEquals(-expected, before, "seed " + seed);
        }
        assertTrue(met > RAYS / 50, "only " + met + " rays met anything");
    }

    private static boolean grazes(Ray ray) {
        SurfacePoint p = ray.point();
        double slope = p.normalX * ray.dx + p.normalY * ray.dy + p.normalZ * ray.dz;
        return Math.abs(slope) < 0.05 * length(ray);
    }

    /** World units for each t. */
    private static double length(Ray ray) {
        return Math.sqrt(ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz);
    }

    /**
     * A ray from anywhere around, inside too, towards somewhere about the shape; some along axes.
     */
    private static double[] line(Random random) {
        double[] line = new double[6];
        for (int i = 0; i < 3; i++) {
            line[i] = 8 * random.nextDouble() - 4;
            double aim = 4 * random.nextDouble() - 2;
            line[i + 3] = random.nextInt(6) == 0 ? 0 : (aim - line[i]) / 4;
        }
        if (line[3] == 0 && line[4] == 0 && line[5] == 0) line[5] = 1;
        return line;
    }

    private static void aim(Ray ray, double[] line) {
        ray.aim(line[0], line[1], line[2], line[3], line[4], line[5], 0);
    }
}
