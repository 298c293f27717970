package rasterlab.engine.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.LightSource;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;

/**
 * The light of a scene.
 *
 * @param model its lights stand in the world
 * @param atEye a light that goes with the eye
 */
public record SceneLight(LightModel model, Optional<LightSource> atEye) {
    private static final double DIFFUSE = 1 - LightModel.AMBIENT;

    /** A lamp at the eye that lights what it faces fully: 0.2 of ambient light, 0.8 of its own. */
    public static SceneLight lampAtEye() {
        double[] white = {DIFFUSE, DIFFUSE, DIFFUSE};
        LightSource lamp =
                new LightSource(
                        new double[3],
                        white,
                        white,
                        LightSource.white().attenuation(),
                        LightSource.white().cone());
        return new SceneLight(
                LightModel.openGl().withLocalViewer().withTwoSides(), Optional.of(lamp));
    }

    /**
     * The model with all lights in the world.
     *
     * @param far whether the eye is infinitely far in the direction (x, y, z)
     * @param x of the eye, or of the direction to it
     */
    public LightModel seenFrom(boolean far, double x, double y, double z) {
        if (atEye.isEmpty()) return model;
        List<Light> lights = new ArrayList<>(model.lights());
        lights.add(far ? Light.from(atEye.get(), x, y, z) : Light.at(atEye.get(), x, y, z));
        return new LightModel(
                model.globalAmbient(),
                model.localViewer(),
                model.twoSided(),
                model.reflection(),
                lights);
    }
}
