package rasterlab.engine.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;

/** The light on many points at once beside that on each of them. */
class BlockLightingTest {
    private static final LightSource WHITE = LightSource.white();

    private static final Light SUN = Light.from(WHITE, 1, 2, 3);

    private static final Light BULB =
            Light.at(WHITE.attenuated(new Attenuation(0.5, 0.1, 0.02)), 2, -1, 3);

    private static final Light SPOT =
            Light.at(WHITE.through(new SpotCone(new double[] {0, 0, -1}, 60, 3)), 0, 0, 2);

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("lights")
    void isTheLightOfEachPointBitForBit(Reflection reflection, double shininess, Light... lights) {
        var model = LightModel.openGl(lights).with(reflection).withLocalViewer();
        var material = new Material(Material.dull(0.9, 0.5, 0.2).surface(), 0.25);
        var lighting =
                new PointLighting(model, material.shiny(0.7, shininess), Material.dull(0, 1, 0));
        lighting.eye(1, 2, 4, 0, 0, 1);
        var blocks = lighting.forBlocks();
        var random = new Random(1975);
        float[] expected = new float[4];
        for (int count : new int[] {BlockLighting.SIZE, 3, 0, 1}) {
            double[][] points = points(random, count);
            for (int i = 0; i < count; i++) put(points[i], blocks, i);
            blocks.light(count);
            for (int i = 0; i < count; i++) {
                double[] p = points[i];
                lighting.shade(p[0], p[1], p[2], p[3], p[4], p[5], false, expected, 0);
                String where = "point %d of %d".formatted(i, count);
                assertEquals(expected[0], blocks.red[i], where);
                assertEquals(expected[1], blocks.green[i], where);
                assertEquals(expected[2], blocks.blue[i], where);
                assertEquals(expected[3], blocks.alpha(), where);
            }
        }
    }

    static Stream<Arguments> lights() {
        return Stream.of(
                argumentSet(
                        "a point that turns away has a highlight",
                        Reflection.BLINN_PHONG,
                        2.0,
                        new Light[] {SUN}),
                argumentSet(
                        "a shininess of 0 lights what turns away",
                        Reflection.PHONG,
                        0.0,
                        new Light[] {SUN}),
                argumentSet(
                        "a broken exponent is cut off", Reflection.PHONG, 2.5, new Light[] {BULB}),
                argumentSet(
                        "a dull surface has highlights",
                        Reflection.LAMBERT,
                        32.0,
                        new Light[] {SUN, BULB}),
                argumentSet(
                        "lights are summed up in another order, or the last one alone counts",
                        Reflection.BLINN_PHONG,
                        7.0,
                        new Light[] {SUN, BULB, SPOT}),
                argumentSet(
                        "without lights the light from everywhere is left out",
                        Reflection.BLINN_PHONG,
                        7.0,
                        new Light[0]));
    }

    /** Places and normals, of any length; the first point's normal is 0. */
    private static double[][] points(Random random, int count) {
        double[][] points = new double[count][6];
        for (int i = 0; i < count; i++)
            for (int k = 0; k < 6; k++)
                points[i][k] = i == 0 && k > 2 ? 0 : 4 * random.nextDouble() - 2;
        return points;
    }

    private static void put(double[] point, BlockLighting blocks, int i) {
        blocks.x[i] = point[0];
        blocks.y[i] = point[1];
        blocks.z[i] = point[2];
        blocks.nx[i] = point[3];
        blocks.ny[i] = point[4];
        blocks.nz[i] = point[5];
    }
}
