package rasterlab.engine.scene.shape;

import rasterlab.engine.range.Finite;

/**
 * A ray {@code p = o + t·d} and the nearest place where it has met a shape so far.
 *
 * <p>Aimed anew for each pixel; shapes then lower t. It counts t above {@code least} only. Where a
 * ray starts on a surface, the rounded t of that very point is a few units of the last place of o
 * about 0: a {@code least} above them leaves it out. One ray belongs to one thread.
 */
public final class Ray {
    /** Powers of t of the steepest equation, that of {@link Revolution}. */
    private static final int MOST_DEGREE = 6;

    final Polynomial equation = new Polynomial(MOST_DEGREE);
    final RayStretch stretch = new RayStretch(this);
    double ox;
    double oy;
    double oz;
    double dx;
    double dy;
    double dz;
    private double least;
    private double t = Double.POSITIVE_INFINITY;
    private final SurfacePoint point = new SurfacePoint();

    /**
     * Starts again with nothing met.
     *
     * @param ox world x of o, in ±{@link SceneShape#LARGEST}, as y and z are
     * @param dx world x of d, in the same range; the largest of the three is at least {@link
     *     Shape#SMALLEST}
     * @param least met places have t above this; finite
     */
    public void aim(
            double ox, double oy, double oz, double dx, double dy, double dz, double least) {
        Size.requireCoordinate("ray's x", ox);
        Size.requireCoordinate("ray's y", oy);
        Size.requireCoordinate("ray's z", oz);
        Size.require(
                "the largest of the ray's direction",
                Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz))));
        Finite.require("least t", least);
        turn(ox, oy, oz, dx, dy, dz);
        this.least = least;
        t = Double.POSITIVE_INFINITY;
    }

    /** Becomes the same ray in other coordinates; what it has met stays. */
    void turn(double ox, double oy, double oz, double dx, double dy, double dz) {
        this.ox = ox;
        this.oy = oy;
        this.oz = oz;
        this.dx = dx;
        this.dy = dy;
        this.dz = dz;
    }

    /** Where, in lengths of d; infinite where it met nothing. */
    public double t() {
        return t;
    }

    /** The place it met, with the outward normal there; undefined where it met nothing. */
    public SurfacePoint point() {
        return point;
    }

    /** Whether the ray came to the place from the side the normal does not point to. */
    public boolean fromInside() {
        return point.normalX * dx + point.normalY * dy + point.normalZ * dz > 0;
    }

    double least() {
        return least;
    }

    /** Whether a place at this t would be the nearest so far. */
    boolean takes(double t) {
        return t > least && t < this.t;
    }

    double x(double t) {
        return ox + t * dx;
    }

    double y(double t) {
        return oy + t * dy;
    }

    double z(double t) {
        return oz + t * dz;
    }

    /** Takes the place at t, which {@link #takes} has let in; the caller writes the rest of it. */
    SurfacePoint take(double t) {
        this.t = t;
        point.place(x(t), y(t), z(t));
        return point;
    }
}
