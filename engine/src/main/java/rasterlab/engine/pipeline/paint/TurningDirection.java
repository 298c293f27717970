package rasterlab.engine.pipeline.paint;

import rasterlab.engine.scene.Mesh;

/**
 * How a direction of length 1 turns over a face.
 *
 * <p>A vector w that is mixed linearly between corners, brought to length 1, is u = w/|w| with
 * {@code |u′| ≤ |w′|/|w|} and {@code u″ = P·w″/|w| − 2·(u·w′/|w|)·u′ − |u′|²·u}, P projecting
 * across u. Derivatives are along the longest side, run through from 0 to 1.
 *
 * @param at x, y, z at each corner
 * @param speed at least |u′|, in radians for the side
 * @param bend at least |u″|
 */
record TurningDirection(double[] at, double speed, double bend) {
    /** A direction that turns by more than this is given up. */
    private static final double MOST = 0.8;

    /** Whether nothing useful is known. */
    boolean wild() {
        return !(speed < MOST);
    }

    int size() {
        return at.length / 3;
    }

    double dot(int corner, TurningDirection other, int otherCorner) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++)
            sum += at[3 * corner + axis] * other.at[3 * otherCorner + axis];
        return sum;
    }

    /** Bounds the second derivative of the cosine between two: at least |(a·b)″|. */
    static double product(TurningDirection a, TurningDirection b) {
        return a.bend + 2 * a.speed * b.speed + b.bend;
    }

    /**
     * The normals that are mixed from a face's corners.
     *
     * <p>Corners have |w| = 1 and sides |w′| ≤ c, so that inside |w|² ≥ 1 − c²/3 and |w·w′| ≤ c²/2.
     *
     * @param sign 1, or −1 for the face's back
     */
    static TurningDirection ofNormals(Mesh mesh, int face, int sign) {
        var at = new double[3 * mesh.cornerCount(face)];
        for (int i = 0; i < at.length; i++) at[i] = sign * mesh.cornerNormal(face, i / 3, i % 3);
        double square = longestSquared(at);
        double length = 1 - square / 3;
        if (!(length > 0)) return new TurningDirection(at, Double.POSITIVE_INFINITY, 0);
        double speed = Math.sqrt(square / length);
        return new TurningDirection(at, speed, speed * speed * (1 + speed));
    }

    /**
     * The directions from a face to a place, or one direction where that is infinitely far.
     *
     * <p>|w′| ≤ h, the longest side, and |w| is at least the nearest corner's less h; |u·w′| ≤ h.
     */
    static TurningDirection towards(Mesh mesh, int face, double[] place, boolean far) {
        int corners = mesh.cornerCount(face);
        var at = new double[3 * corners];
        var places = new double[3 * corners];
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < corners; k++) {
            int v = mesh.corner(face, k);
            double[] corner = {mesh.x(v), mesh.y(v), mesh.z(v)};
            double square = 0;
            for (int axis = 0; axis < 3; axis++) {
                places[3 * k + axis] = corner[axis];
                at[3 * k + axis] = far ? place[axis] : place[axis] - corner[axis];
                square += at[3 * k + axis] * at[3 * k + axis];
            }
            double length = Math.sqrt(square);
            nearest = Math.min(nearest, length);
            for (int axis = 0; axis < 3; axis++) at[3 * k + axis] /= length;
        }
        if (far) return new TurningDirection(at, 0, 0);
        double side = Math.sqrt(longestSquared(places));
        double room = nearest - side;
        if (!(room > 0)) return new TurningDirection(at, Double.POSITIVE_INFINITY, 0);
        double speed = side / room;
        return new TurningDirection(at, speed, 3 * speed * speed);
    }

    /** The direction half way between two: w = a + b, |w″| at most the sum of both bends. */
    static TurningDirection between(TurningDirection a, TurningDirection b) {
        var at = new double[a.at.length];
        double shortest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < a.size(); k++) {
            double square = 0;
            for (int i = 3 * k; i < 3 * k + 3; i++) {
                at[i] = a.at[i] + b.at[i];
                square += at[i] * at[i];
            }
            double length = Math.sqrt(square);
            shortest = Math.min(shortest, length);
            for (int i = 3 * k; i < 3 * k + 3; i++) at[i] /= length;
        }
        double room = shortest - a.speed - b.speed;
        if (!(room > 0)) return new TurningDirection(at, Double.POSITIVE_INFINITY, 0);
        double speed = (a.speed + b.speed) / room;
        return new TurningDirection(at, speed, (a.bend + b.bend) / room + 3 * speed * speed);
    }

    /** The light's direction l mirrored at the normal n: r = 2·(n·l)·n − l. */
    static TurningDirection mirrored(TurningDirection n, TurningDirection l) {
        var at = new double[n.at.length];
        for (int k = 0; k < n.size(); k++) {
            double twice = 2 * n.dot(k, l, k);
            for (int i = 3 * k; i < 3 * k + 3; i++) at[i] = twice * n.at[i] - l.at[i];
        }
        double both = n.speed + l.speed;
        double bend = 2 * (product(n, l) + 2 * both * n.speed + n.bend) + l.bend;
        return new TurningDirection(at, 2 * n.speed + l.speed, bend);
    }

    private static double longestSquared(double[] xyz) {
        double most = 0;
        for (int a = 0; a < xyz.length; a += 3)
            for (int b = a + 3; b < xyz.length; b += 3) {
                double dx = xyz[a] - xyz[b];
                double dy = xyz[a + 1] - xyz[b + 1];
                double dz = xyz[a + 2] - xyz[b + 2];
                most = Math.max(most, dx * dx + dy * dy + dz * dz);
            }
        return most;
    }
}
