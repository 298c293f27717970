package rasterlab.app.light;

import java.util.Arrays;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/** Maps the world to a picture of the lab and back: lamps and normals. */
public record PicturePlaces(ViewedMesh view) {
    /** Length of an arrow in world units. */
    private static final double ARROW = 16;

    /** The share of ρ that a lamp nearer to the eye is taken to be away. */
    private static final double NEAREST = 0.05;

    static PicturePlaces of(LightChoice choice, Scene body, int width, int height) {
        return new PicturePlaces(
                new ViewedMesh(
                        body.mesh(),
                        new ViewTransform(choice.camera(), Projection.PERSPECTIVE),
                        PictureFit.of(width, height, choice.zoom() * body.pictureScale())));
    }

    /** Pixel x, y and view depth z of a world point. */
    public double[] toPicture(double x, double y, double z) {
        ViewTransform transform = view.transform();
        double least = NEAREST * transform.distance();
        double depth = Math.max(least, transform.toEye(2, x, y, z));
        double shrink = transform.distance() / depth;
        return new double[] {
            view.fit().toPixelX(transform.toEye(0, x, y, z) * shrink),
            view.fit().toPixelY(transform.toEye(1, x, y, z) * shrink),
            depth
        };
    }

    /** The world point at a pixel and a view depth. */
    public double[] toWorld(double pixelX, double pixelY, double depth) {
        ViewTransform transform = view.transform();
        double spread = depth / transform.distance();
        double x = view.fit().toPlaneX(pixelX) * spread;
        double y = view.fit().toPlaneY(pixelY) * spread;
        var world = new double[3];
        for (int axis = 0; axis < 3; axis++) world[axis] = transform.toWorld(axis, x, y, depth);
        return world;
    }

    /** The arrows from the middle of each face whose outside is seen. */
    double[] faceArrows() {
        Mesh mesh = view.mesh();
        var ends = new double[4 * mesh.faceCount()];
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++) {
            if (view.seenFromInside(f)) continue;
            var middle = new double[3];
            int corners = mesh.cornerCount(f);
            for (int k = 0; k < corners; k++) {
                int v = mesh.corner(f, k);
                middle[0] += mesh.x(v) / corners;
                middle[1] += mesh.y(v) / corners;
                middle[2] += mesh.z(v) / corners;
            }
            double[] normal = {mesh.normalX(f), mesh.normalY(f), mesh.normalZ(f)};
            put(middle, normal, ends, at);
            at += 4;
        }
        return Arrays.copyOf(ends, at);
    }

    /**
     * The arrows from each corner of such faces, as the shadings of corners and pixels have them.
     */
    double[] cornerArrows() {
        Mesh mesh = view.mesh();
        var ends = new double[4 * mesh.totalCorners()];
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++) {
            if (view.seenFromInside(f)) continue;
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                double[] corner = {mesh.x(v), mesh.y(v), mesh.z(v)};
                double[] normal = {
                    mesh.cornerNormal(f, k, 0),
                    mesh.cornerNormal(f, k, 1),
                    mesh.cornerNormal(f, k, 2)
                };
                put(corner, normal, ends, at);
                at += 4;
            }
        }
        return Arrays.copyOf(ends, at);
    }

    /** The vertices that those arrows begin at, in the same order. */
    int[] cornerVertices() {
        Mesh mesh = view.mesh();
        return IntStream.range(0, mesh.faceCount())
                .filter(f -> !view.seenFromInside(f))
                .flatMap(f -> IntStream.range(0, mesh.cornerCount(f)).map(k -> mesh.corner(f, k)))
                .toArray();
    }

    private void put(double[] point, double[] normal, double[] ends, int at) {
        double[] from = toPicture(point[0], point[1], point[2]);
        double[] to =
                toPicture(
                        point[0] + ARROW * normal[0],
                        point[1] + ARROW * normal[1],
                        point[2] + ARROW * normal[2]);
        ends[at] = from[0];
        ends[at + 1] = from[1];
        ends[at + 2] = to[0];
        ends[at + 3] = to[1];
    }
}
