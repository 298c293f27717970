package rasterlab.engine.sight;

/**
 * The depths that a scene can have for all cameras of a range, from the ball about the origin that
 * holds it.
 *
 * @param near at most the least eye z that is drawn, world units
 * @param far at least the largest eye z
 * @param secant at least the length of a line of sight for 1 of eye z, anywhere on the picture
 * @param whole whether the near plane cuts nothing off
 */
public record DepthReach(double near, double far, double secant, boolean whole) {

    /**
     * @param radius of the ball
     * @param nearest the least distance of an eye from the origin
     * @param farthest the largest one
     * @param plane the near plane's eye z
     * @param tangent of the picture's corner, seen from the eye
     */
    public static DepthReach of(
            double radius, double nearest, double farthest, double plane, double tangent) {
        double least = nearest - radius;
        return new DepthReach(
                Math.max(plane, least),
                farthest + radius,
                Math.hypot(1, tangent),
                least > plane && plane > 0);
    }
}
