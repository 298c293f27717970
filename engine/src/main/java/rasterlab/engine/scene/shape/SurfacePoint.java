package rasterlab.engine.scene.shape;

/** Receives a point of a {@link Patch}; used again for the next one. */
public final class SurfacePoint {
    double x;
    double y;
    double z;
    double normalX;
    double normalY;
    double normalZ;
    double s;
    double t;

    void place(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    void normal(double x, double y, double z) {
        normalX = x;
        normalY = y;
        normalZ = z;
    }

    void texture(double s, double t) {
        this.s = s;
        this.t = t;
    }

    /** World units. */
    public double x() {
        return x;
    }

    public double y() {
        return y;
    }

    public double z() {
        return z;
    }

    /** Coordinate x of the outward normal of length 1. */
    public double normalX() {
        return normalX;
    }

    public double normalY() {
        return normalY;
    }

    public double normalZ() {
        return normalZ;
    }

    /** Texture coordinate from left to right. */
    public double s() {
        return s;
    }

    /** Texture coordinate from bottom to top. */
    public double t() {
        return t;
    }
}
