package rasterlab.engine.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;

class PointLightingTest {
    private static final Material WHITE = Material.dull(1, 1, 1);
    private static final Material RED = Material.dull(1, 0, 0);
    private static final Light SUN = Light.from(light(0.5), 0, 0, 2);

    @Test
    void lightsOfSeveralSourcesAddUp() {
        var lighting = lighting(dark(SUN, Light.from(light(0.25), 0, 0, 1)), WHITE);
        assertArrayEquals(new float[] {0.75f, 0.75f, 0.75f, 1}, shade(lighting, 0, 0, 1, false));
    }

    @Test
    void sumIsCutOnceAtTheEndAndNotForEachSource() {
        var strong = Light.from(light(3), 0, 0, 1);
        var lighting = lighting(dark(strong, strong), Material.dull(0.1, 0.2, 1));
        assertArrayEquals(new float[] {0.6f, 1, 1, 1}, shade(lighting, 0, 0, 1, false));
    }

    @Test
    void backIsLitByItsOwnMaterialWithTheNormalTurnedRound() {
        var model = dark(SUN).withTwoSides();
        var lighting = new PointLighting(model, WHITE, RED);
        assertArrayEquals(new float[] {0.5f, 0, 0, 1}, shade(lighting, 0, 0, -1, true));
        assertArrayEquals(new float[] {0, 0, 0, 1}, shade(lighting, 0, 0, -1, false));
    }

    @Test
    void backOfAOneSidedModelIsLitAsTheFront() {
        var lighting = new PointLighting(dark(SUN), WHITE, RED);
        assertArrayEquals(new float[] {0, 0, 0, 1}, shade(lighting, 0, 0, -1, true));
        assertArrayEquals(new float[] {0.5f, 0.5f, 0.5f, 1}, shade(lighting, 0, 0, 1, true));
    }

    private static LightModel with(Reflection reflection, LightModel model) {
        return new LightModel(
                model.globalAmbient(),
                model.localViewer(),
                model.twoSided(),
                reflection,
                model.lights());
    }

    @Test
    void localViewerSeesTheHighlightElsewhere() {
        var model = with(Reflection.PHONG, dark(Light.from(light(1), 0, 0, 1)));
        var shiny = Material.dull(0, 0, 0).shiny(1, 1);
        var far = lighting(model, shiny);
        far.eye(3, 0, 4, 0, 0, 1);
        assertEquals(1, shade(far, 0, 0, 1, false)[0]);
        var near = lighting(model.withLocalViewer(), shiny);
        near.eye(3, 0, 4, 0, 0, 1);
        assertEquals(0.8, shade(near, 0, 0, 1, false)[0], 1e-6);
    }

    @Test
    void normalsNeedNotHaveLength1() {
        var lighting = lighting(dark(SUN), WHITE);
        assertArrayEquals(
                shade(lighting, 0.6, 0, 0.8, false), shade(lighting, 0.15, 0, 0.2, false), 1e-7f);
    }

    @Test
    void pointWithoutNormalHasAmbientLightAndEmissionOnly() {
        double[] glow = {0.1, 0, 0};
        double[] half = {0.5, 0.5, 0.5};
        var surface = new SurfaceMaterial(half, half, half, glow, 5);
        var model = LightModel.openGl(Light.from(LightSource.white(), 0, 0, 1));
        var lighting = lighting(model, new Material(surface, 0.25));
        assertArrayEquals(
                new float[] {0.2f, 0.1f, 0.1f, 0.25f}, shade(lighting, 0, 0, 0, false), 1e-7f);
    }

    @Test
    void lightInThePointHasNoDirectionAndGivesNoNaN() {
        var lamp = light(1).attenuated(new Attenuation(0, 0, 1));
        var lighting = lighting(dark(Light.at(lamp, 0, 0, 0)), WHITE);
        assertArrayEquals(new float[] {0, 0, 0, 1}, shade(lighting, 0, 0, 1, false));
    }

    @Test
    void vertexColorStandsForAmbientAndDiffuseShares() {
        var lighting = lighting(dark(SUN), RED);
        float[] rgba = {9, 0.2f, 0.4f, 0.6f, 0.8f};
        lighting.shadeColored(0, 0, 0, 0, 0, 1, false, rgba, 1);
        assertArrayEquals(new float[] {9, 0.1f, 0.2f, 0.3f, 0.8f}, rgba, 1e-7f);
    }

    @Test
    void packedColorIsTheSharesRounded() {
        var lighting = lighting(dark(SUN), new Material(RED.surface(), 0.25));
        assertEquals(0x40800000, lighting.argb(0, 0, 0, 0, 0, 1, false));
    }

    @Test
    void allocatesNothingPerPoint() {
        var spot = light(1).through(new SpotCone(new double[] {0, 0, -1}, 60, 3));
        var model =
                with(Reflection.PHONG, LightModel.openGl(SUN, Light.at(spot, 1, 1, 3)))
                        .withLocalViewer();
        var lighting = lighting(model, Material.dull(0.5, 0.5, 0.5).shiny(0.5, 30));
        lighting.eye(0, 0, 5, 0, 0, 1);
        var rgba = new float[4];
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 10_000; i++)
                lighting.shade(i * 1e-4, 0, 0, i * 1e-5, 0, 1, false, rgba, 0);
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertTrue(least < 10_000, least + " bytes for 10,000 points");
    }

    @Test
    void farLightHasNeitherConeNorAttenuation() {
        var weak = LightSource.white().attenuated(new Attenuation(1, 1, 0));
        var refusal = assertThrows(IllegalArgumentException.class, () -> Light.from(weak, 0, 0, 1));
        assertEquals(
                "a directional light has neither cone nor attenuation, got cutoff 180.0 and"
                        + " Attenuation[constant=1.0, linear=1.0, quadratic=0.0]",
                refusal.getMessage());
    }

    private static LightSource light(double diffuse) {
        double[] gray = {diffuse, diffuse, diffuse};
        return new LightSource(new double[3], gray, gray, Attenuation.none(), SpotCone.none());
    }

    private static LightModel dark(Light... lights) {
        return new LightModel(new double[3], false, false, Reflection.BLINN_PHONG, List.of(lights));
    }

    private static PointLighting lighting(LightModel model, Material material) {
        return new PointLighting(model, material, material);
    }

    private static float[] shade(
            PointLighting lighting, double nx, double ny, double nz, boolean back) {
        var rgba = new float[4];
        lighting.shade(0, 0, 0, nx, ny, nz, back, rgba, 0);
        return rgba;
    }
}
