package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.engine.transform.Angle;

/**
 * Brings the axis onto z by a shift and two turns, turns about z, and undoes the three.
 *
 * <p>With the unit direction (l, m, n) and d = √(l² + m²): the turn about z by −θ, cos θ = l/d, sin
 * θ = m/d, takes (l, m, n) to (d, 0, n); the turn about y by −φ, cos φ = n, sin φ = d, takes that
 * to (0, 0, 1). An axis along z has d = 0 and no θ; any will do, so 0 is taken. Where d has lost
 * digits, being as small as doubles get, l/d and m/d would be no cosine and sine: l and m are made
 * larger before.
 *
 * <p>Source: D. F. Rogers, J. A. Adams, Mathematical Elements for Computer Graphics, 1976, chapter
 * 3.
 */
public final class SevenSteps extends SteppedAxisRotation {
    private static final double SMALL = 0x1p-500;
    private static final double ENLARGED = 0x1p600;

    @Override
    List<AxisStep> steps(double[] through, double[] k, double degrees) {
        double d = Math.hypot(k[0], k[1]);
        double[] across = heading(k[0], k[1]);
        double cosTheta = across[0];
        double sinTheta = across[1];
        var aboutZ =
                new AxisStep.Turn(
                        "turn about z by −θ: the axis into zx", 0, 1, -sinTheta, cosTheta);
        var aboutY = new AxisStep.Turn("turn about y by −φ: the axis onto z", 2, 0, -d, k[2]);
        Angle by = Angle.ofDegrees(degrees);
        return List.of(
                new AxisStep.Shift("move the axis through the origin", through, -1),
                aboutZ,
                aboutY,
                new AxisStep.Turn("turn about z by the angle", 0, 1, by.sin(), by.cos()),
                aboutY.back("turn about y by φ"),
                aboutZ.back("turn about z by θ"),
                new AxisStep.Shift("move back", through, 1));
    }

    /** (l, m) brought to length 1, or (1, 0) where both are 0. */
    private static double[] heading(double l, double m) {
        if (l == 0 && m == 0) return new double[] {1, 0};
        boolean small = Math.max(Math.abs(l), Math.abs(m)) < SMALL;
        double x = small ? l * ENLARGED : l;
        double y = small ? m * ENLARGED : m;
        double length = Math.hypot(x, y);
        return new double[] {x / length, y / length};
    }
}
