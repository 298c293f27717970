package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;

/**
 * A mesh in eye space (x right, y up, z forward), one array per coordinate.
 *
 * <p>The arrays are shared with the methods for speed and are not written after construction.
 */
public final class ViewedMesh {
    /**
     * The nearest depth that is drawn in perspective, as a share of ρ. It keeps the division by z
     * away from 0.
     */
    public static final double NEAR_SHARE = 1e-3;

    private final Mesh mesh;
    private final ViewTransform transform;
    private final PictureFit fit;
    private final double near;
    private final double far;
    private final List<ClipPlane> clipPlanes;
    private final double[][] eyePlanes;
    final double[] eyeX;
    final double[] eyeY;
    public final double[] eyeZ;
    private final double[] eyeNormals;

    /**
     * @param near the smallest eye z that is drawn, above 0 in perspective
     * @param far the largest one, above {@code near}; infinity in perspective, and infinities in
     *     parallel projection, cut nothing off
     * @param clipPlanes what else cuts
     */
    public ViewedMesh(
            Mesh mesh,
            ViewTransform transform,
            PictureFit fit,
            double near,
            double far,
            List<ClipPlane> clipPlanes) {
        if (!(near < far) || transform.central() && !(near > 0))
            throw new IllegalArgumentException(
                    "near must be below far%s, got near %s, far %s"
                            .formatted(transform.central() ? " and above 0" : "", near, far));
        this.mesh = mesh;
        this.transform = transform;
        this.fit = fit;
        this.near = near;
        this.far = far;
        this.clipPlanes = ClipPlane.checked(clipPlanes);
        eyePlanes = this.clipPlanes.stream().map(p -> p.inEye(transform)).toArray(double[][]::new);
        int n = mesh.vertexCount();
        eyeX = new double[n];
        eyeY = new double[n];
        eyeZ = new double[n];
        eyeNormals = new double[3 * mesh.faceCount()];
        for (int v = 0; v < n; v++) {
            eyeX[v] = transform.toEye(0, mesh.x(v), mesh.y(v), mesh.z(v));
            eyeY[v] = transform.toEye(1, mesh.x(v), mesh.y(v), mesh.z(v));
            eyeZ[v] = transform.toEye(2, mesh.x(v), mesh.y(v), mesh.z(v));
        }
        for (int f = 0; f < mesh.faceCount(); f++) turnNormal(f);
    }

    /** A view without clip planes. */
    public ViewedMesh(Mesh mesh, ViewTransform transform, PictureFit fit, double near, double far) {
        this(mesh, transform, fit, near, far, List.of());
    }

    /** A view with the nearest near plane there can be, and no far one. */
    public ViewedMesh(Mesh mesh, ViewTransform transform, PictureFit fit) {
        this(
                mesh,
                transform,
                fit,
                transform.central() ? NEAR_SHARE * transform.distance() : Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY);
    }

    private void turnNormal(int face) {
        double length = 0;
        for (int axis = 0; axis < 3; axis++) {
            double turned =
                    transform.normalToEye(
                            axis, mesh.normalX(face), mesh.normalY(face), mesh.normalZ(face));
            eyeNormals[3 * face + axis] = turned;
            length += turned * turned;
        }
        if (!transform.projection().oblique()) return;
        for (int axis = 0; axis < 3; axis++) eyeNormals[3 * face + axis] /= Math.sqrt(length);
    }

    public Mesh mesh() {
        return mesh;
    }

    public ViewTransform transform() {
        return transform;
    }

    public PictureFit fit() {
        return fit;
    }

    public double eyeX(int vertex) {
        return eyeX[vertex];
    }

    public double eyeY(int vertex) {
        return eyeY[vertex];
    }

    public double eyeZ(int vertex) {
        return eyeZ[vertex];
    }

    /** The outward normal of a face in eye space, of length 1: axis 0 is x, 1 is y, 2 is z. */
    public double eyeNormal(int face, int axis) {
        return eyeNormals[3 * face + axis];
    }

    /**
     * n·p of the face's plane in eye space. It is negative when the eye, at the origin, is on the
     * outer side.
     */
    public double planeOffset(int face) {
        int corner = mesh.corner(face, 0);
        return eyeNormal(face, 0) * eyeX[corner]
                + eyeNormal(face, 1) * eyeY[corner]
                + eyeNormal(face, 2) * eyeZ[corner];
    }

    /** Whether the picture shows the inner side of a face, if it shows the face at all. */
    public boolean seenFromInside(int face) {
        return transform.central() ? planeOffset(face) > 0 : eyeNormal(face, 2) > 0;
    }

    /** The smallest z in eye space that is drawn: negative infinity where there is no bound. */
    public double near() {
        return near;
    }

    /** The largest z in eye space that is drawn: infinity where there is no bound. */
    public double far() {
        return far;
    }

    /** The planes that cut besides near and far ones, in the world. */
    public List<ClipPlane> clipPlanes() {
        return clipPlanes;
    }

    /** How many planes cut besides near and far ones. */
    public int clipPlaneCount() {
        return eyePlanes.length;
    }

    /** a·x + b·y + c·z + d of a clip plane for a point in eye space: drawn from 0 up. */
    public double clipDistance(int plane, double x, double y, double z) {
        double[] p = eyePlanes[plane];
        return p[0] * x + p[1] * y + p[2] * z + p[3];
    }

    /** Whether a plane of any kind cuts off a corner of the mesh that is not too far away. */
    public boolean cutsOpen() {
        for (int v = 0; v < eyeX.length; v++) {
            if (eyeZ[v] < near) return true;
            for (int plane = 0; plane < eyePlanes.length; plane++)
                if (clipDistance(plane, eyeX[v], eyeY[v], eyeZ[v]) < 0) return true;
        }
        return false;
    }
}
