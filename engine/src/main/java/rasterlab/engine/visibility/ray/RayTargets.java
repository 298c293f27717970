package rasterlab.engine.visibility.ray;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.OnePlane;

/**
 * The faces of a mesh as a ray meets them: planes n·p = c, each bounded by the planes that stand on
 * its edges and look inwards.
 */
final class RayTargets {
    /** How far outside an edge still counts as on it, as a share of the faces' radius. */
    private static final double ON_EDGE = 0x1p-46;

    private final double[] planes;
    private final double[][] walls;
    private final double radius;

    RayTargets(Mesh mesh) {
        int faces = mesh.faceCount();
        planes = new double[4 * faces];
        walls = new double[faces][];
        radius = farthestCorner(mesh);
        for (int f = 0; f < faces; f++) {
            double nx = mesh.normalX(f);
            double ny = mesh.normalY(f);
            double nz = mesh.normalZ(f);
            int v = mesh.corner(f, 0);
            double c = nx * mesh.x(v) + ny * mesh.y(v) + nz * mesh.z(v);
            System.arraycopy(new double[] {nx, ny, nz, c}, 0, planes, 4 * f, 4);
            walls[f] = walls(mesh, f);
        }
    }

    /** A vertex that belongs to no face is nowhere, however far off. */
    private static double farthestCorner(Mesh mesh) {
        double farthest = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                farthest = Math.max(farthest, length(mesh.x(v), mesh.y(v), mesh.z(v)));
            }
        return farthest;
    }

    /** Four numbers per edge: the inward unit normal and its offset, lowered by the tolerance. */
    private double[] walls(Mesh mesh, int face) {
        int n = mesh.cornerCount(face);
        double[] walls = new double[4 * n];
        for (int k = 0; k < n; k++) {
            int a = mesh.corner(face, k);
            int b = mesh.corner(face, (k + 1) % n);
            double ex = mesh.x(b) - mesh.x(a);
            double ey = mesh.y(b) - mesh.y(a);
            double ez = mesh.z(b) - mesh.z(a);
            double edge = length(ex, ey, ez);
            if (edge == 0) continue;
            double wx = (mesh.normalY(face) * ez - mesh.normalZ(face) * ey) / edge;
            double wy = (mesh.normalZ(face) * ex - mesh.normalX(face) * ez) / edge;
            double wz = (mesh.normalX(face) * ey - mesh.normalY(face) * ex) / edge;
            double offset = wx * mesh.x(a) + wy * mesh.y(a) + wz * mesh.z(a);
            double[] wall = {wx, wy, wz, offset - ON_EDGE * radius};
            System.arraycopy(wall, 0, walls, 4 * k, 4);
        }
        return walls;
    }

    /**
     * How far along the ray it meets a face; NaN where it does not.
     *
     * @param ray origin in 0..2, direction in 3..5
     */
    double meets(int face, double[] ray) {
        int at = 4 * face;
        double toward = planes[at] * ray[3] + planes[at + 1] * ray[4] + planes[at + 2] * ray[5];
        if (toward == 0) return Double.NaN;
        double t =
                (planes[at + 3]
                                - planes[at] * ray[0]
                                - planes[at + 1] * ray[1]
                                - planes[at + 2] * ray[2])
                        / toward;
        return inside(walls[face], ray, t) ? t : Double.NaN;
    }

    /** The most by which rounding parts depths at which a ray meets one plane. */
    double room(double t) {
        return OnePlane.room(Math.abs(t) + radius);
    }

    /** Whether two faces are in one plane, whichever sides they turn to the eye. */
    boolean onePlane(int one, int other) {
        int a = 4 * one;
        int b = 4 * other;
        double turn = 0;
        for (int i = 0; i < 3; i++) turn += planes[a + i] * planes[b + i];
        double side = Math.signum(turn);
        double apart = Math.abs(planes[a + 3] - side * planes[b + 3]);
        for (int i = 0; i < 3; i++)
            apart += radius * Math.abs(planes[a + i] - side * planes[b + i]);
        return apart <= OnePlane.room(radius);
    }

    private static boolean inside(double[] walls, double[] ray, double t) {
        double x = ray[0] + t * ray[3];
        double y = ray[1] + t * ray[4];
        double z = ray[2] + t * ray[5];
        for (int w = 0; w < walls.length; w += 4) {
            double inwards = walls[w] * x + walls[w + 1] * y + walls[w + 2] * z;
            // The value is NaN where the ray is nearly parallel: then it meets nothing.
            if (!(inwards >= walls[w + 3])) return false;
        }
        return true;
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
