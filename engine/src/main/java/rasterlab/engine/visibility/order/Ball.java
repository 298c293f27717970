package rasterlab.engine.visibility.order;

/**
 * A ball round a piece, to see at a glance that two pieces cannot be in each other's way; with room
 * for rounding.
 *
 * @param distance of the middle from the eye
 */
record Ball(double x, double y, double z, double radius, double distance) {
    private static final double ROOM = 1 + 1e-9;

    static Ball round(double[] corners, double[] eye) {
        int count = corners.length / 3;
        var middle = new double[3];
        for (int i = 0; i < corners.length; i++) middle[i % 3] += (corners[i] - eye[i % 3]) / count;
        double radius = 0;
        for (int i = 0; i < count; i++) {
            double dx = corners[3 * i] - eye[0] - middle[0];
            double dy = corners[3 * i + 1] - eye[1] - middle[1];
            double dz = corners[3 * i + 2] - eye[2] - middle[2];
            radius = Math.max(radius, Math.hypot(Math.hypot(dx, dy), dz));
        }
        double distance = Math.hypot(Math.hypot(middle[0], middle[1]), middle[2]);
        return new Ball(middle[0], middle[1], middle[2], radius * ROOM, distance);
    }

    /** Whether all of this is farther from the eye than all of the other. */
    boolean farther(Ball other) {
        return distance - radius > (other.distance + other.radius) * ROOM;
    }

    /** Whether no ray from the eye meets both. */
    boolean apartFrom(Ball other) {
        if (distance <= radius || other.distance <= other.radius) return false;
        double cos =
                (x / distance) * (other.x / other.distance)
                        + (y / distance) * (other.y / other.distance)
                        + (z / distance) * (other.z / other.distance);
        double between = Math.acos(Math.max(-1, Math.min(1, cos)));
        double reach = Math.asin(radius / distance) + Math.asin(other.radius / other.distance);
        return between > reach + 1e-6;
    }
}
