package rasterlab.engine.scene.catalogue;

import org.joml.Matrix4d;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.light.Light;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.Cylinder;
import rasterlab.engine.scene.shape.Placed;
import rasterlab.engine.scene.shape.Quad;
import rasterlab.engine.scene.shape.Sphere;
import rasterlab.engine.transform.SphericalView;

/** The finishes that can be seen through. */
final class GlassScenes {
    private static final int[] PANES = {0xE05050, 0x50C060, 0x5080E0};

    private GlassScenes() {}

    /** A ball of glass around a tube, lit by a lamp that is seen. */
    static Recipe sphereAndCylinder() {
        return new Recipe("sphere-and-cylinder", 32, GlassScenes::sphereAndCylinder);
    }

    private static Scene sphereAndCylinder(int detail) {
        var camera = new SphericalView(0.5, 1.05, 500);
        int across = Math.max(3, detail / 2);
        var lamp = new Matrix4d().translate(90, -75, 120);
        var tube = new Placed(Cylinder.open(42, 110), new Matrix4d().rotateX(0.35));
        return new Parts()
                .add(Appearances.satin(0xD9A441), tube, detail, 4)
                .add(Appearances.glowing(0xFFF6D0), new Placed(new Sphere(9), lamp), detail, across)
                .add(Appearances.glass(0x9CC8F0, 0.3), new Sphere(105), detail, across)
                .scene(
                        "sphere-and-cylinder",
                        Lamps.of(
                                Light.at(Lamps.source(0.75, 0.9), 90, -75, 120),
                                Light.from(Lamps.source(0.3, 0), 1, 1, 0.3)),
                        camera,
                        2);
    }

    /** A ball among three panes of coloured glass. */
    static Recipe transparency() {
        return new Recipe("transparency", 32, GlassScenes::transparency);
    }

    private static Scene transparency(int detail) {
        var camera = new SphericalView(0.9, 1.2, 500);
        var parts = new Parts();
        var ball = new Matrix4d().translate(-10, 0, 0);
        parts.add(
                Appearances.glossy(0xF0E0C0),
                new Placed(new Sphere(45), ball),
                detail,
                Math.max(3, detail / 2));
        for (int k = 0; k < PANES.length; k++)
            parts.add(Appearances.glass(PANES[k], 0.45), pane(-75 + 75.0 * k, 45.0 * (k - 1)));
        return parts.scene("transparency", Lamps.leftOf(camera), camera, 1.8);
    }

    private static Quad pane(double x, double y) {
        return Quad.whole(new Vector(x, y, 0), new Vector(0, 60, 0), new Vector(0, 0, 75));
    }
}
