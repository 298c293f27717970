package rasterlab.app.clip.scene;

/** A point of the space in which the view volume is |x| ≤ z, |y| ≤ z, zmin ≤ z ≤ 1; any doubles. */
public record SpacePoint(double x, double y, double z) {
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }
}
