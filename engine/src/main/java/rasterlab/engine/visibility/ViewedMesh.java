package rasterlab.engine.visibility;

import org.joml.Matrix4d;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;

/**
 * A mesh in eye space (x right, y up, z forward), one array per coordinate.
 *
 * <p>The arrays are shared with the methods for speed and are not written after construction.
 */
public final class ViewedMesh {
    /**
     * What lies nearer to the eye than this share of ρ is not drawn in perspective. It keeps the
     * division by z away from 0.
     */
    public static final double NEAR_SHARE = 1e-3;

    private final Mesh mesh;
    private final SphericalView camera;
    private final Projection projection;
    private final PictureFit fit;
    final double[] eyeX;
    final double[] eyeY;
    final double[] eyeZ;
    private final double[] eyeNormals;

    public ViewedMesh(Mesh mesh, SphericalView camera, Projection projection, PictureFit fit) {
        this.mesh = mesh;
        this.camera = camera;
        this.projection = projection;
        this.fit = fit;
        int n = mesh.vertexCount();
        eyeX = new double[n];
        eyeY = new double[n];
        eyeZ = new double[n];
        eyeNormals = new double[3 * mesh.faceCount()];
        Matrix4d m = camera.matrix();
        for (int v = 0; v < n; v++) {
            double x = mesh.x(v);
            double y = mesh.y(v);
            double z = mesh.z(v);
            eyeX[v] = m.m00() * x + m.m10() * y + m.m20() * z + m.m30();
            eyeY[v] = m.m01() * x + m.m11() * y + m.m21() * z + m.m31();
            eyeZ[v] = m.m02() * x + m.m12() * y + m.m22() * z + m.m32();
        }
        turnNormals(m);
    }

    private void turnNormals(Matrix4d m) {
        for (int f = 0; f < mesh.faceCount(); f++) {
            double x = mesh.normalX(f);
            double y = mesh.normalY(f);
            double z = mesh.normalZ(f);
            eyeNormals[3 * f] = m.m00() * x + m.m10() * y + m.m20() * z;
            eyeNormals[3 * f + 1] = m.m01() * x + m.m11() * y + m.m21() * z;
            eyeNormals[3 * f + 2] = m.m02() * x + m.m12() * y + m.m22() * z;
        }
    }

    public Mesh mesh() {
        return mesh;
    }

    public SphericalView camera() {
        return camera;
    }

    public Projection projection() {
        return projection;
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
        return projection == Projection.PERSPECTIVE
                ? planeOffset(face) > 0
                : eyeNormal(face, 2) > 0;
    }

    /** The smallest z in eye space that is drawn: negative infinity in parallel projection. */
    public double near() {
        return projection == Projection.PERSPECTIVE
                ? NEAR_SHARE * camera.rho()
                : Double.NEGATIVE_INFINITY;
    }
}
