package rasterlab.engine.plan;

import rasterlab.engine.plan.BlockBounds.BlockBound;
import rasterlab.engine.transform.ViewTransform;

/**
 * The places where the eye may be while a camera turns about the origin and comes nearer, as seen
 * from a surface.
 *
 * @param towards the eye's x, y, z, world units; in parallel projection the direction to it
 * @param central whether lines of sight meet in the eye
 * @param moves how far it may move from there about the origin, world units; in parallel projection
 *     how far its direction may turn, radians
 * @param nearer how far it may move along the line to the origin, either way, world units
 */
record EyeRange(double[] towards, boolean central, double moves, double nearer) {
    /** The eyes of the cameras that have turned by at most an angle, in radians. */
    static EyeRange of(ViewTransform transform, double turn) {
        double[] towards = new double[3];
        double rho = transform.central() ? transform.distance() : 1;
        for (int axis = 0; axis < 3; axis++) towards[axis] = -rho * transform.sight(axis);
        if (!transform.central()) return new EyeRange(towards, false, turn, 0);
        double moves = 2 * rho * Math.sin(turn / 2);
        return new EyeRange(towards, true, moves, rho * (CameraRange.ZOOM - 1));
    }

    /**
     * The least |cos θ| between a block's normals and the directions to the eye; 0 where the block
     * may be seen from the side.
     */
    double leastCosine(BlockBound block) {
        double[] normal = block.normal();
        double[] way = towards.clone();
        if (central) for (int axis = 0; axis < 3; axis++) way[axis] -= block.middle()[axis];
        double distance = Math.sqrt(dot(way, way));
        double apart = central ? block.radius() + moves : 0;
        if (!(distance > apart + nearer)) return 0;
        double spread = block.cone() + (central ? turned(way, distance, apart) : moves);
        double raised = Math.asin(Math.min(1, Math.abs(dot(way, normal)) / distance));
        return Math.sin(Math.max(0, raised - spread));
    }

    /**
     * How far the direction to the eye may turn, radians: by what is moved aside, and by the part
     * of the way to the origin that is not along it.
     */
    private double turned(double[] way, double distance, double apart) {
        double along = dot(way, towards) / (distance * Math.sqrt(dot(towards, towards)));
        double aside = nearer * Math.sqrt(Math.max(0, 1 - along * along));
        return Math.asin(apart / distance) + Math.asin(aside / (distance - apart - nearer));
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
