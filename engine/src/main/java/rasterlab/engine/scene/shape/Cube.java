package rasterlab.engine.scene.shape;

import java.util.List;
import rasterlab.engine.geometry.Vector;

/**
 * A cube about the origin with its edges along the axes; each face shows the texture once, upright
 * on the four around the z axis.
 *
 * <p>A ray is inside the cube where it is between all three pairs of planes: from the last plane it
 * enters by to the first it leaves by. A place lies within a few units of the last place of |o| +
 * edge of the face.
 *
 * @param edge length, world units
 */
public record Cube(double edge) implements SceneShape {
    public Cube {
        Size.require("cube's edge", edge);
    }

    @Override
    public List<Patch> patches() {
        double h = edge / 2;
        return List.of(
                face(h, 0, 0, 0, h, 0, 0, 0, h),
                face(-h, 0, 0, 0, -h, 0, 0, 0, h),
                face(0, h, 0, -h, 0, 0, 0, 0, h),
                face(0, -h, 0, h, 0, 0, 0, 0, h),
                face(0, 0, h, h, 0, 0, 0, h, 0),
                face(0, 0, -h, h, 0, 0, 0, -h, 0));
    }

    /** Centre, right and up; see {@link Quad}. */
    private static Quad face(double... v) {
        return Quad.whole(
                new Vector(v[0], v[1], v[2]),
                new Vector(v[3], v[4], v[5]),
                new Vector(v[6], v[7], v[8]));
    }

    @Override
    public boolean isConvexBody() {
        return true;
    }

    @Override
    public void meet(Ray ray) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        int enterAxis = 0;
        int leaveAxis = 0;
        for (int axis = 0; axis < 3; axis++) {
            double o = axis == 0 ? ray.ox : axis == 1 ? ray.oy : ray.oz;
            double d = direction(ray, axis);
            if (d == 0) {
                if (Math.abs(o) > edge / 2) return;
                continue;
            }
            double in = (-Math.copySign(edge / 2, d) - o) / d;
            double out = (Math.copySign(edge / 2, d) - o) / d;
            if (in > enter) {
                enter = in;
                enterAxis = axis;
            }
            if (out < leave) {
                leave = out;
                leaveAxis = axis;
            }
        }
        if (enter > leave) return;
        if (ray.takes(enter)) take(ray, enter, enterAxis, -1);
        else if (ray.takes(leave)) take(ray, leave, leaveAxis, 1);
    }

    private static double direction(Ray ray, int axis) {
        return axis == 0 ? ray.dx : axis == 1 ? ray.dy : ray.dz;
    }

    /**
     * @param way 1 where the ray leaves through the face, −1 where it enters
     */
    private void take(Ray ray, double t, int axis, int way) {
        double sign = way * Math.signum(direction(ray, axis));
        SurfacePoint out = ray.take(t);
        out.normal(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
        double right = axis == 0 ? sign * out.y : axis == 1 ? -sign * out.x : out.x;
        double up = axis == 2 ? sign * out.y : out.z;
        out.texture(0.5 + right / edge, 0.5 + up / edge);
    }
}
