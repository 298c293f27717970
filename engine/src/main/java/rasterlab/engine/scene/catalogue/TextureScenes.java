package rasterlab.engine.scene.catalogue;

import org.joml.Matrix4d;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.Placed;
import rasterlab.engine.scene.shape.Quad;
import rasterlab.engine.scene.shape.Sphere;
import rasterlab.engine.scene.shape.TexturePlace;
import rasterlab.engine.transform.SphericalView;

/** Pictures laid on surfaces. */
final class TextureScenes {
    /** The earth's axis against the z axis, in radians. */
    private static final double TILT = Math.toRadians(23.4);

    private TextureScenes() {}

    /**
     * A slanting quad whose corners are at uneven places of the texture: cut into two triangles it
     * has a crease, in finer steps it has less of one.
     */
    static Recipe quad() {
        return new Recipe("textured-quad", 3, TextureScenes::quad);
    }

    private static Scene quad(int detail) {
        var camera = new SphericalView(0.35, 1.1, 560);
        var quad =
                new Quad(
                        new Vector(0, 0, 0),
                        new Vector(0, 140, 0),
                        new Vector(-150, 0, 40),
                        new TexturePlace(0, 0),
                        new TexturePlace(2, 0),
                        new TexturePlace(1.5, 1),
                        new TexturePlace(0.25, 2));
        return new Parts()
                .add(Appearances.pictured(Pictures.letters()), quad, detail, detail)
                .scene("textured-quad", Lamps.leftOf(camera), camera, 1.75);
    }

    /** A ball with an earth-like picture. */
    static Recipe globe() {
        return new Recipe("globe", 48, TextureScenes::globe);
    }

    private static Scene globe(int detail) {
        var camera = new SphericalView(0.6, 1.25, 500);
        var tilted = new Placed(new Sphere(105), new Matrix4d().rotateX(TILT));
        return new Parts()
                .add(
                        Appearances.pictured(Pictures.earth()),
                        tilted,
                        detail,
                        Math.max(3, detail / 2))
                .scene("globe", Lamps.leftOf(camera), camera, 2.1);
    }
}
