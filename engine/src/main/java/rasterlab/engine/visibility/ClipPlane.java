package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.transform.ViewTransform;

/**
 * A plane in world space that cuts off what is beyond it: drawn is where {@code a·x + b·y + c·z + d
 * ≥ 0}. It stays in its place in the world wherever the eye goes.
 *
 * @param a of the normal, which points into what is drawn and needs no length
 * @param b of the normal
 * @param c of the normal
 * @param d moves the plane against the normal, by world units where that has length 1
 */
public record ClipPlane(double a, double b, double c, double d) {
    /** The most planes that may cut one picture. */
    public static final int MOST = 6;

    /** The largest number of a plane: what is computed with it stays finite. */
    public static final double LARGEST = 1e30;

    public ClipPlane {
        for (double number : new double[] {a, b, c, d})
            if (!(Math.abs(number) <= LARGEST))
                throw new IllegalArgumentException(
                        "numbers of a clip plane must be from %s to %s, got %s"
                                .formatted(-LARGEST, LARGEST, number));
        if (a == 0 && b == 0 && c == 0)
            throw new IllegalArgumentException(
                    "a clip plane needs a direction: a, b or c other than 0");
    }

    /**
     * These planes, which are not too many.
     *
     * @throws IllegalArgumentException for more than {@value #MOST}
     */
    public static List<ClipPlane> checked(List<ClipPlane> planes) {
        if (planes.size() > MOST)
            throw new IllegalArgumentException(
                    "at most %d clip planes can cut, got %d".formatted(MOST, planes.size()));
        return List.copyOf(planes);
    }

    /** The value of the plane's equation, above 0 on the drawn side, 0 in the plane. */
    public double at(double x, double y, double z) {
        return a * x + b * y + c * z + d;
    }

    /** a, b, c, d for points in eye space, which may be slanted. */
    double[] inEye(ViewTransform transform) {
        double[] plane = new double[4];
        plane[3] = ofEye(transform, 0, 0, 0);
        plane[0] = ofEye(transform, 1, 0, 0) - plane[3];
        plane[1] = ofEye(transform, 0, 1, 0) - plane[3];
        plane[2] = ofEye(transform, 0, 0, 1) - plane[3];
        return plane;
    }

    private double ofEye(ViewTransform transform, double x, double y, double z) {
        return at(
                transform.toWorld(0, x, y, z),
                transform.toWorld(1, x, y, z),
                transform.toWorld(2, x, y, z));
    }
}
