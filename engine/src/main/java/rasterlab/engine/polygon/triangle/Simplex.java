package rasterlab.engine.polygon.triangle;

/**
 * Maps the triangle to the unit simplex (0, 0), (1, 0), (0, 1) and looks there.
 *
 * <p>With c moved to the origin the corners a and b are the rows of M = [ax ay; bx by], and {@code
 * (u v) = (x y)·M⁻¹}, {@code M⁻¹ = [by −ay; −bx ax] / (ax·by − ay·bx)}. Inside where u ≥ 0, v ≥ 0
 * and u + v ≤ 1.
 *
 * <p>A triangle without area has no inverse and is refused. The division rounds, so points on the
 * sides fall to either.
 */
final class Simplex implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        SideTests.requireFinite(ax, ay, bx, by, cx, cy, x, y);
        double ux = ax - cx;
        double uy = ay - cy;
        double vx = bx - cx;
        double vy = by - cy;
        double area = ux * vy - uy * vx;
        if (area == 0 || !Double.isFinite(area))
            throw new IllegalArgumentException(
                    "the triangle's doubled area must be neither 0 nor beyond doubles, got "
                            + area);
        double px = x - cx;
        double py = y - cy;
        double u = (px * vy - py * vx) / area;
        if (u < 0) return -1;
        double v = (py * ux - px * uy) / area;
        if (v < 0) return -2;
        return u + v <= 1 ? 3 : -3;
    }

    @Override
    public int multiplicationsPerSide() {
        return 2;
    }

    @Override
    public int additionsPerSide() {
        return 3;
    }
}
