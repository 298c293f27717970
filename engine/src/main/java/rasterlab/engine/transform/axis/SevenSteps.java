package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.engine.transform.Angle;

/**
 * Brings the axis onto z by a shift and two turns, turns about z, and undoes the three.
 *
 * <p>With the unit direction (l, m, n) and d = √(l² + m²): the turn about z by −θ, cos θ = l/d, sin
 * θ = m/d, takes (l, m, n) to (d, 0, n); the turn about y by −φ, cos φ = n, sin φ = d, takes that
 * to (0, 0, 1). An axis along z has d = 0 and no θ; any will do, so 0 is taken.
 *
 * <p>Source: D. F. Rogers, J. A. Adams, Mathematical Elements for Computer Graphics, 1976, chapter
 * 3.
 */
public final class SevenSteps extends SteppedAxisRotation {
    @Override
    List<AxisStep> steps(double[] through, double[] k, double degrees) {
        double d = Math.hypot(k[0], k[1]);
        double cosTheta = d == 0 ? 1 : k[0] / d;
        double sinTheta = d == 0 ? 0 : k[1] / d;
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
}
