package rasterlab.engine.visibility;

import java.util.Optional;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;

/**
 * The point of a mesh that a pixel shows, in the world.
 *
 * @param face number of the face
 * @param behind whether its inner side is seen
 * @param position x, y, z
 * @param normal of the corners, mixed as the point lies between them, outwards, of length 1; that
 *     of the face where they cancel out
 * @param fan of the triangle in which it lies, the face's corners 0, {@code fan} and {@code fan +
 *     1}
 * @param weights of these three corners, whose mean it is by them: none negative, their sum 1
 */
public record SeenPoint(
        int face, boolean behind, double[] position, double[] normal, int fan, double[] weights) {
    public SeenPoint {
        position = position.clone();
        normal = normal.clone();
        weights = weights.clone();
    }

    @Override
    public double[] position() {
        return position.clone();
    }

    @Override
    public double[] normal() {
        return normal.clone();
    }

    @Override
    public double[] weights() {
        return weights.clone();
    }

    /**
     * The point of a face that a pixel shows.
     *
     * @throws IllegalArgumentException if the face is seen edge-on
     */
    public static SeenPoint of(ViewedMesh view, int face, int x, int y) {
        var plane = new NearnessPlane();
        if (!plane.load(view, face))
            throw new IllegalArgumentException("face " + face + " is seen edge-on");
        return point(view, face, plane.base + x * plane.perColumn + y * plane.perRow, x, y);
    }

    /** The nearest face that owns the pixel; empty where none does. */
    public static Optional<SeenPoint> at(ViewedMesh view, int x, int y) {
        var polygon = new ScreenPolygon(view);
        var plane = new NearnessPlane();
        var owned = new boolean[1];
        double nearest = Double.NEGATIVE_INFINITY;
        int found = -1;
        for (int face = 0; face < view.mesh().faceCount(); face++) {
            if (!plane.load(view, face)) continue;
            double nearness = plane.base + x * plane.perColumn + y * plane.perRow;
            if (nearness <= nearest) continue;
            owned[0] = false;
            polygon.load(view, face);
            polygon.fill(
                    view.fit().width(),
                    view.fit().height(),
                    (row, from, to) -> owned[0] |= row == y && from <= x && x < to);
            if (!owned[0]) continue;
            nearest = nearness;
            found = face;
        }
        return found < 0 ? Optional.empty() : Optional.of(point(view, found, nearest, x, y));
    }

    private static SeenPoint point(ViewedMesh view, int face, double nearness, int x, int y) {
        ViewTransform transform = view.transform();
        PictureFit fit = view.fit();
        double z = transform.central() ? transform.distance() / nearness : -nearness;
        double spread = transform.central() ? z / transform.distance() : 1;
        double viewX = fit.toPlaneX(x) * spread;
        double viewY = fit.toPlaneY(y) * spread;
        var position = new double[3];
        for (int axis = 0; axis < 3; axis++)
            position[axis] = transform.toWorld(axis, viewX, viewY, z);
        return at(view.mesh(), face, view.seenFromInside(face), position);
    }

    /**
     * The point in the triangle of the fan about the first corner that holds it, or nearly does.
     */
    private static SeenPoint at(Mesh mesh, int face, boolean behind, double[] point) {
        double best = Double.NEGATIVE_INFINITY;
        double[] weights = {1, 0, 0};
        int fan = 1;
        for (int k = 1; k + 1 < mesh.cornerCount(face); k++) {
            double[] shares = shares(mesh, face, k, point);
            double least = Math.min(shares[0], Math.min(shares[1], shares[2]));
            if (!(least > best)) continue;
            best = least;
            weights = shares;
            fan = k;
        }
        double[] normal = mixed(mesh, face, fan, weights);
        return new SeenPoint(face, behind, point, normal, fan, within(weights));
    }

    /** The weights without what rounding made negative. */
    private static double[] within(double[] weights) {
        var within = new double[3];
        double sum = 0;
        for (int k = 0; k < 3; k++) sum += within[k] = Math.max(0, weights[k]);
        for (int k = 0; k < 3; k++) within[k] /= sum;
        return within;
    }

    private static double[] mixed(Mesh mesh, int face, int fan, double[] weights) {
        var normal = new double[3];
        double length = 0;
        for (int axis = 0; axis < 3; axis++) {
            normal[axis] =
                    weights[0] * mesh.cornerNormal(face, 0, axis)
                            + weights[1] * mesh.cornerNormal(face, fan, axis)
                            + weights[2] * mesh.cornerNormal(face, fan + 1, axis);
            length += normal[axis] * normal[axis];
        }
        if (!(length > 0))
            return new double[] {mesh.normalX(face), mesh.normalY(face), mesh.normalZ(face)};
        for (int axis = 0; axis < 3; axis++) normal[axis] /= Math.sqrt(length);
        return normal;
    }

    /** The areas of the point with each two corners, as shares of the triangle's. */
    private static double[] shares(Mesh mesh, int face, int k, double[] point) {
        double[] a = corner(mesh, face, 0);
        double[] b = corner(mesh, face, k);
        double[] c = corner(mesh, face, k + 1);
        double whole = area(mesh, face, a, b, c);
        return new double[] {
            area(mesh, face, point, b, c) / whole,
            area(mesh, face, a, point, c) / whole,
            area(mesh, face, a, b, point) / whole
        };
    }

    private static double[] corner(Mesh mesh, int face, int corner) {
        int v = mesh.corner(face, corner);
        return new double[] {mesh.x(v), mesh.y(v), mesh.z(v)};
    }

    /** Twice the area, as the face's normal sees it. */
    private static double area(Mesh mesh, int face, double[] a, double[] b, double[] c) {
        double px = b[0] - a[0];
        double py = b[1] - a[1];
        double pz = b[2] - a[2];
        double qx = c[0] - a[0];
        double qy = c[1] - a[1];
        double qz = c[2] - a[2];
        return (py * qz - pz * qy) * mesh.normalX(face)
                + (pz * qx - px * qz) * mesh.normalY(face)
                + (px * qy - py * qx) * mesh.normalZ(face);
    }
}
