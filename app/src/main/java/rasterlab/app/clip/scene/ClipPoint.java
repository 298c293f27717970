package rasterlab.app.clip.scene;

/** A place in the plane, x to the right and y up; any doubles. */
public record ClipPoint(double x, double y) {
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }
}
