package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/**
 * A shape turned, moved and stretched: p′ = M·p.
 *
 * <p>A ray is taken back by the inverse of M; its t stays what it was, as its direction is not
 * brought to length 1. Normals go by the transposed inverse and are brought to length 1 again.
 */
public final class Placed implements SceneShape {
    private final SceneShape shape;
    private final Matrix4d toWorld;
    private final Matrix4d toShape;

    /**
     * @param toWorld affine, with a determinant above 0: a mirror image would be inside out
     */
    public Placed(SceneShape shape, Matrix4dc toWorld) {
        double determinant = toWorld.determinant();
        boolean affine =
                toWorld.m03() == 0
                        && toWorld.m13() == 0
                        && toWorld.m23() == 0
                        && toWorld.m33() == 1;
        if (!affine || !(determinant > 0 && determinant < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "toWorld must be affine with a finite determinant above 0, got %s and\n%s"
                            .formatted(determinant, toWorld));
        this.shape = shape;
        this.toWorld = new Matrix4d(toWorld);
        toShape = toWorld.invertAffine(new Matrix4d());
    }

    @Override
    public List<Patch> patches() {
        List<Patch> placed = new ArrayList<>();
        for (Patch patch : shape.patches()) placed.add(new PlacedPatch(patch));
        return placed;
    }

    @Override
    public boolean isConvexBody() {
        return shape.isConvexBody();
    }

    @Override
    public void meet(Ray ray) {
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double before = ray.t();
        ray.turn(
                along(toShape, 0, ox, oy, oz) + toShape.m30(),
                along(toShape, 1, ox, oy, oz) + toShape.m31(),
                along(toShape, 2, ox, oy, oz) + toShape.m32(),
                along(toShape, 0, dx, dy, dz),
                along(toShape, 1, dx, dy, dz),
                along(toShape, 2, dx, dy, dz));
        shape.meet(ray);
        ray.turn(ox, oy, oz, dx, dy, dz);
        if (ray.t() < before) {
            turnNormal(ray.point());
            ray.point().place(ray.x(ray.t()), ray.y(ray.t()), ray.z(ray.t()));
        }
    }

    /** Row {@code row} of the matrix without its last column, times (x, y, z). */
    private static double along(Matrix4d matrix, int row, double x, double y, double z) {
        return matrix.get(0, row) * x + matrix.get(1, row) * y + matrix.get(2, row) * z;
    }

    private void turnNormal(SurfacePoint out) {
        double x = out.normalX;
        double y = out.normalY;
        double z = out.normalZ;
        double nx = toShape.m00() * x + toShape.m01() * y + toShape.m02() * z;
        double ny = toShape.m10() * x + toShape.m11() * y + toShape.m12() * z;
        double nz = toShape.m20() * x + toShape.m21() * y + toShape.m22() * z;
        double length = Math.hypot(Math.hypot(nx, ny), nz);
        out.normal(nx / length, ny / length, nz / length);
    }

    private final class PlacedPatch implements Patch {
        private final Patch patch;

        PlacedPatch(Patch patch) {
            this.patch = patch;
        }

        @Override
        public boolean isFlat() {
            return patch.isFlat();
        }

        @Override
        public Span u() {
            return patch.u();
        }

        @Override
        public Span v() {
            return patch.v();
        }

        @Override
        public boolean isPole(double v) {
            return patch.isPole(v);
        }

        @Override
        public int vSteps(int asked) {
            return patch.vSteps(asked);
        }

        @Override
        public void at(double u, double v, SurfacePoint out) {
            patch.at(u, v, out);
            double x = out.x;
            double y = out.y;
            double z = out.z;
            out.place(
                    along(toWorld, 0, x, y, z) + toWorld.m30(),
                    along(toWorld, 1, x, y, z) + toWorld.m31(),
                    along(toWorld, 2, x, y, z) + toWorld.m32());
            turnNormal(out);
        }
    }
}
