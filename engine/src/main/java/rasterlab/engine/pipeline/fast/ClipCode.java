package rasterlab.engine.pipeline.fast;

/**
 * Which planes a vertex is beyond, one bit each.
 *
 * <p>A triangle with all vertices beyond one plane of the picture is out of sight. One that crosses
 * near, far, w = 0, a plane of the user or the guard is clipped; beyond the picture's sides alone
 * it is drawn as it is, and rows and columns outside are skipped.
 */
final class ClipCode {
    static final int LEFT = 1;
    static final int RIGHT = 2;
    static final int BOTTOM = 4;
    static final int TOP = 8;
    static final int NEAR = 16;
    static final int FAR = 32;
    static final int NO_W = 64;
    static final int GUARD = 128;
    static final int FIRST_USER = 256;

    /** The smallest w that anything is divided by. */
    static final float SMALLEST_W = 1e-30f;

    /** The sides beyond one of which alone a triangle is still drawn whole. */
    private static final int SIDES = LEFT | RIGHT | BOTTOM | TOP;

    private ClipCode() {}

    static int of(float x, float y, float z, float w) {
        int code = 0;
        if (x < -w) code |= LEFT;
        if (x > w) code |= RIGHT;
        if (y < -w) code |= BOTTOM;
        if (y > w) code |= TOP;
        if (z < -w) code |= NEAR;
        if (z > w) code |= FAR;
        if (w < SMALLEST_W) code |= NO_W;
        float guard = Subpixels.GUARD * w;
        if (Math.abs(x) > guard || Math.abs(y) > guard) code |= GUARD;
        return code;
    }

    /** The bits of the user's planes for a world point. */
    static int ofUser(double[][] planes, float x, float y, float z) {
        int code = 0;
        for (int k = 0; k < planes.length; k++)
            if (distance(planes[k], x, y, z) < 0) code |= FIRST_USER << k;
        return code;
    }

    static double distance(double[] plane, float x, float y, float z) {
        return plane[0] * x + plane[1] * y + plane[2] * z + plane[3];
    }

    /**
     * @param all what every vertex has
     */
    static boolean outOfSight(int all) {
        return (all & ~GUARD) != 0;
    }

    /**
     * @param any what some vertex has
     */
    static boolean mustClip(int any) {
        return (any & ~SIDES) != 0;
    }
}
