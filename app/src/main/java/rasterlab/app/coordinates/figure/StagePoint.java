package rasterlab.app.coordinates.figure;

/** A place in the plane of the stage; not finite where a point has no image. */
public record StagePoint(double x, double y) {
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }
}
