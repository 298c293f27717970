package rasterlab.engine.scene.catalogue;

import java.util.Optional;
import org.joml.Vector3d;
import rasterlab.contract.LightSource;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.transform.SphericalView;

/** The light of scenes that are shown with shadings: a lamp beside the first view. */
final class Lamps {
    private Lamps() {}

    /**
     * A lamp to the left of the eye and above it, which gives highlights off the middle, and a dim
     * one from the right, without highlights.
     */
    static SceneLight leftOf(SphericalView camera) {
        Vector3d eye = camera.eye();
        var right = new Vector3d(-eye.y, eye.x, 0).normalize();
        var up = new Vector3d(eye).cross(right).normalize();
        Vector3d lamp = from(eye, right, -0.8, up, 0.9, camera.rho());
        Vector3d fill = from(eye, right, 1.2, up, -0.2, camera.rho());
        return of(
                Light.at(source(0.75, 0.9), lamp.x, lamp.y, lamp.z),
                Light.at(source(0.2, 0), fill.x, fill.y, fill.z));
    }

    private static Vector3d from(
            Vector3d eye, Vector3d right, double toRight, Vector3d up, double upwards, double rho) {
        return new Vector3d(eye).fma(toRight * rho, right).fma(upwards * rho, up);
    }

    static SceneLight of(Light... lights) {
        return new SceneLight(
                LightModel.openGl(lights).withLocalViewer().withTwoSides(), Optional.empty());
    }

    /** Warm or cold makes no difference: all shares are equal. */
    static LightSource source(double diffuse, double specular) {
        LightSource white = LightSource.white();
        return new LightSource(
                new double[3],
                new double[] {diffuse, diffuse, diffuse},
                new double[] {specular, specular, specular},
                white.attenuation(),
                white.cone());
    }
}
