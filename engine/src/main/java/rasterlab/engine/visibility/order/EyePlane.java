package rasterlab.engine.visibility.order;

/**
 * The plane n·p = c in seen coordinates, n of length 1, turned so that the eye at the origin is on
 * its positive side or in it: c ≤ 0.
 *
 * <p>A point counts as in the plane within {@link #TOLERANCE} of the sum of its coordinates' sizes
 * and those of the plane's own corner, which is some hundred times what corners, cuts and normals
 * lose to rounding.
 *
 * @param reach sum of the sizes of the coordinates of a point of the plane
 */
record EyePlane(double nx, double ny, double nz, double c, double reach) {
    private static final double TOLERANCE = 0x1p-45;

    /** Bits of {@link #sides}. */
    static final int NEAR = 1;

    static final int FAR = 2;

    /** The plane through corner 0 of {@code seen}, at right angles to n of length 1. */
    static EyePlane through(double[] seen, double nx, double ny, double nz) {
        double c = nx * seen[0] + ny * seen[1] + nz * seen[2];
        double reach = Math.abs(seen[0]) + Math.abs(seen[1]) + Math.abs(seen[2]);
        return c > 0 ? new EyePlane(-nx, -ny, -nz, -c, reach) : new EyePlane(nx, ny, nz, c, reach);
    }

    /** Whether it is seen edge on. */
    boolean holdsEye() {
        return -c <= TOLERANCE * reach;
    }

    /** The signed distance of corner i, 0 within the tolerance. */
    double at(double[] seen, int i) {
        double x = seen[3 * i];
        double y = seen[3 * i + 1];
        double z = seen[3 * i + 2];
        double distance = nx * x + ny * y + nz * z - c;
        double allowed = TOLERANCE * (Math.abs(x) + Math.abs(y) + Math.abs(z) + reach);
        return Math.abs(distance) <= allowed ? 0 : distance;
    }

    /** The sides on which a polygon has corners: {@link #NEAR}, {@link #FAR}, both or none. */
    int sides(double[] seen) {
        int sides = 0;
        for (int i = 0; i < seen.length / 3; i++) {
            double distance = at(seen, i);
            if (distance > 0) sides |= NEAR;
            if (distance < 0) sides |= FAR;
        }
        return sides;
    }

    /**
     * The plane through the eye and an edge of a polygon, with the polygon on its positive side. An
     * edge that points at the eye has none: everything is in the answer then, whose normal is 0.
     */
    static EyePlane throughEdge(Facet facet, int edge) {
        double[] p = facet.seen();
        int i = 3 * edge;
        int j = (i + 3) % p.length;
        double nx = p[i + 1] * p[j + 2] - p[i + 2] * p[j + 1];
        double ny = p[i + 2] * p[j] - p[i] * p[j + 2];
        double nz = p[i] * p[j + 1] - p[i + 1] * p[j];
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (length == 0) return new EyePlane(0, 0, 0, 0, 0);
        double sign = facet.turn() / length;
        return new EyePlane(sign * nx, sign * ny, sign * nz, 0, 0);
    }
}
