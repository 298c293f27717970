package rasterlab.engine.visibility.triangle;

/**
 * The plane through the three corners of a triangle with depths.
 *
 * <p>With A = (x₁ − x₀)(y₂ − y₀) − (x₂ − x₀)(y₁ − y₀), twice the area, each corner's weight at a
 * point is the A of the triangle that the point makes with the other two corners; A and the weights
 * are exact in double on multiples of 1/256. The depth is (w₀z₀ + w₁z₁ + w₂z₂)/A, a mean, whatever
 * the shape.
 */
final class TrianglePlane {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double area;

    TrianglePlane(double[] x, double[] y, double[] z) {
        this.x = x;
        this.y = y;
        this.z = z;
        area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    }

    /** Twice the area, above 0 where the corners go round clockwise on the screen. */
    double area() {
        return area;
    }

    /** The weight of a corner beside the two others: {@link #area} at the corner itself. */
    private double weight(int corner, double px, double py) {
        int a = (corner + 1) % 3;
        int b = (corner + 2) % 3;
        return (x[b] - x[a]) * (py - y[a]) - (y[b] - y[a]) * (px - x[a]);
    }

    double depth(double px, double py) {
        double sum = 0;
        for (int i = 0; i < 3; i++) sum += weight(i, px, py) * z[i];
        return sum / area;
    }

    /** ∂z/∂x, from a column to the next. */
    double perColumn() {
        return ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / area;
    }

    /** ∂z/∂y, from a row to the next. */
    double perRow() {
        return ((x[1] - x[0]) * (z[2] - z[0]) - (x[2] - x[0]) * (z[1] - z[0])) / area;
    }

    /** Whether a centre belongs to the triangle, by its weights and the side of each edge. */
    boolean owns(double px, double py) {
        if (area == 0) return false;
        for (int i = 0; i < 3; i++) {
            double inward = inward(i, px, py);
            if (inward < 0 || inward == 0 && !leftOrTop(i)) return false;
        }
        return true;
    }

    /** The distance, above 0 on the inner side of the edge opposite a corner, 0 on it. */
    double inward(int corner, double px, double py) {
        return weight(corner, px, py) * Math.signum(area);
    }

    /** Whether the edge opposite a corner is a left or a top one. */
    private boolean leftOrTop(int corner) {
        int a = (corner + 1) % 3;
        int b = (corner + 2) % 3;
        double dx = (x[b] - x[a]) * Math.signum(area);
        double dy = (y[b] - y[a]) * Math.signum(area);
        return dy < 0 || dy == 0 && dx > 0;
    }
}
