package rasterlab.engine.light.normals;

/**
 * Tells surfaces whose vertex normals do not hang on rounding: no face is narrower than a hundredth
 * of its longest side, no side is shorter than that of its ends' coordinates, and no vertex's faces
 * cancel to less than a tenth. What rounding turns a normal by, some 2⁻⁵³, grows by the products.
 */
final class OrdinarySurface {
    private static final double NARROWEST = 0.01;
    private static final double LEAST_LEFT = 0.1;

    private final double[] xyz;

    /** Σ αᵢ·nᵢ of each vertex, and Σ αᵢ. */
    private final double[] sums;

    private final double[] angles;

    private OrdinarySurface(double[] xyz) {
        this.xyz = xyz;
        sums = new double[xyz.length];
        angles = new double[xyz.length / 3];
    }

    static boolean is(TriangleSurface surface) {
        var check = new OrdinarySurface(surface.vertices());
        int[] corners = surface.triangles();
        for (int t = 0; t < corners.length; t += 3)
            if (!check.isOrdinary(corners[t], corners[t + 1], corners[t + 2])) return false;
        return check.nowhereCancels();
    }

    private boolean isOrdinary(int a, int b, int c) {
        double[] ab = edge(a, b);
        double[] bc = edge(b, c);
        double[] ca = edge(c, a);
        double longest = Math.max(length(ab), Math.max(length(bc), length(ca)));
        double[] normal = cross(ab, bc);
        double twiceArea = length(normal);
        if (!(twiceArea >= NARROWEST * longest * longest)) return false;
        if (!isLong(ab, a, b) || !isLong(bc, b, c) || !isLong(ca, c, a)) return false;
        add(a, Math.atan2(twiceArea, -dot(ab, ca)), normal, twiceArea);
        add(b, Math.atan2(twiceArea, -dot(bc, ab)), normal, twiceArea);
        add(c, Math.atan2(twiceArea, -dot(ca, bc)), normal, twiceArea);
        return true;
    }

    private boolean isLong(double[] side, int from, int to) {
        double most = 0;
        for (int axis = 0; axis < 3; axis++)
            most =
                    Math.max(
                            most,
                            Math.max(Math.abs(xyz[3 * from + axis]), Math.abs(xyz[3 * to + axis])));
        return length(side) >= NARROWEST * most;
    }

    private void add(int vertex, double angle, double[] normal, double length) {
        for (int axis = 0; axis < 3; axis++)
            sums[3 * vertex + axis] += angle * normal[axis] / length;
        angles[vertex] += angle;
    }

    private boolean nowhereCancels() {
        for (int v = 0; v < angles.length; v++) {
            double[] sum = {sums[3 * v], sums[3 * v + 1], sums[3 * v + 2]};
            if (length(sum) < LEAST_LEFT * angles[v]) return false;
        }
        return true;
    }

    private double[] edge(int from, int to) {
        var edge = new double[3];
        for (int axis = 0; axis < 3; axis++) edge[axis] = xyz[3 * to + axis] - xyz[3 * from + axis];
        return edge;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double length(double[] v) {
        return Math.sqrt(dot(v, v));
    }
}
