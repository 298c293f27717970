package rasterlab.engine.scene.catalogue;

import org.joml.Matrix4d;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.Cube;
import rasterlab.engine.scene.shape.Cylinder;
import rasterlab.engine.scene.shape.Placed;
import rasterlab.engine.scene.shape.Quad;
import rasterlab.engine.scene.shape.Sphere;
import rasterlab.engine.scene.shape.TexturePlace;
import rasterlab.engine.transform.SphericalView;

/** Scenes on which methods that order faces, or trust depths, go wrong. */
final class OrderScenes {
    private static final int[] PAINTS = {0xD9534F, 0x5BAF5B, 0x4F86D9};

    /** World units: a few steps of 24 bits over the depths of the scene, and of a float. */
    private static final double HAIR = 5e-5;

    private OrderScenes() {}

    /** Three boards, each over the next: no order of whole faces is right. */
    static Recipe cyclicOverlap() {
        return Recipe.plain(
                "cyclic-overlap",
                () -> {
                    var parts = new Parts();
                    for (int k = 0; k < PAINTS.length; k++)
                        parts.add(Appearances.satin(PAINTS[k]), new Cube(1), board(k));
                    var camera = new SphericalView(0.3, 0.55, 500);
                    return parts.scene("cyclic-overlap", Lamps.leftOf(camera), camera, 2.1);
                });
    }

    /** Board k lies beside the z axis, its end further round the axis above its beginning. */
    private static Matrix4d board(int k) {
        return new Matrix4d()
                .rotateZ(2 * Math.PI * k / PAINTS.length)
                .translate(0, -40, 0)
                .rotateY(-0.25)
                .scale(230, 30, 12);
    }

    /** A ball in a cube that is too small for it, and a board through both. */
    static Recipe interpenetrating() {
        return new Recipe("interpenetrating", 32, OrderScenes::interpenetrating);
    }

    private static Scene interpenetrating(int detail) {
        var camera = new SphericalView(0.5, 1.1, 500);
        var board = new Matrix4d().rotateZ(1.75).rotateX(0.5).scale(250, 90, 8);
        return new Parts()
                .add(Appearances.satin(0xC9A25B), new Cube(120))
                .add(Appearances.glossy(0xD9534F), new Sphere(78), detail, Math.max(3, detail / 2))
                .add(Appearances.satin(0x4F86D9), new Cube(1), board)
                .scene("interpenetrating", Lamps.leftOf(camera), camera, 2.1);
    }

    /**
     * Three squares turned against each other. The first two are in one plane: which is in front?
     * The third leans through it, out by a hair: by more than doubles lose, by less than most depth
     * buffers can tell.
     */
    static Recipe coplanar() {
        return Recipe.plain(
                "coplanar",
                () -> {
                    var parts = new Parts();
                    parts.add(Appearances.satin(PAINTS[0]), sheet(0, 0));
                    parts.add(Appearances.satin(PAINTS[1]), sheet(1, 0));
                    parts.add(Appearances.satin(PAINTS[2]), sheet(2, HAIR));
                    var camera = new SphericalView(-1.1, 0.75, 500);
                    return parts.scene("coplanar", Lamps.leftOf(camera), camera, 1.75);
                });
    }

    /**
     * A sheet in the plane z = 0, which no rounding leads out of.
     *
     * @param lean how far above it the middle of one side is, in world units, and the opposite one
     *     below
     */
    private static Quad sheet(int k, double lean) {
        double along = 110 * Math.cos(0.4 * k);
        double across = 110 * Math.sin(0.4 * k);
        return Quad.whole(
                new Vector(0, 0, 0),
                new Vector(along, across, lean),
                new Vector(-across, along, 0));
    }

    /** A hall that begins far behind the eye, and a beam from beside the eye to the far wall. */
    static Recipe nearPlane() {
        return new Recipe("near-plane", 24, OrderScenes::nearPlane);
    }

    private static Scene nearPlane(int detail) {
        var camera = new SphericalView(0.02, 1.4, 160);
        var parts = new Parts();
        parts.add(Appearances.pictured(Pictures.checker()), floor());
        parts.add(Appearances.satin(0x7F93A8), wall(-90, 1));
        parts.add(Appearances.satin(0x7F93A8), wall(90, -1));
        var beam = new Matrix4d().translate(0, 30, -2).scale(900, 10, 10);
        parts.add(Appearances.satin(0xC9A25B), new Cube(1), beam);
        for (int k = 0; k < 3; k++) {
            var place = new Matrix4d().translate(-130.0 * k - 20, k % 2 == 0 ? -55 : 50, 5);
            var column = new Placed(Cylinder.closed(16, 90), place);
            parts.add(Appearances.glossy(PAINTS[k]), column, detail, 1);
        }
        return parts.scene("near-plane", Lamps.leftOf(camera), camera, 2.6);
    }

    private static Quad floor() {
        return new Quad(
                new Vector(0, 0, -40),
                new Vector(900, 0, 0),
                new Vector(0, 90, 0),
                new TexturePlace(0, 0),
                new TexturePlace(10, 0),
                new TexturePlace(10, 1),
                new TexturePlace(0, 1));
    }

    /** A long wall at y, seen from the side of y that {@code inwards} has the sign of. */
    private static Quad wall(double y, int inwards) {
        return Quad.whole(
                new Vector(0, y, 5), new Vector(-900.0 * inwards, 0, 0), new Vector(0, 0, 45));
    }
}
