package rasterlab.engine.circle;

/**
 * An ellipse in whole pixels, its axes along rows and columns: an input of topic {@code ellipse}.
 */
public record Ellipse(int centerX, int centerY, int radiusX, int radiusY) {
    @Override
    public String toString() {
        return "half-axes "
                + radiusX
                + ", "
                + radiusY
                + " about ("
                + centerX
                + ", "
                + centerY
                + ")";
    }
}
