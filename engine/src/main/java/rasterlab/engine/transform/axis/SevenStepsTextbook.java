package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.engine.transform.Angle;

/**
 * The seven steps as the course prints them: the axis never reaches z, so it moves itself.
 *
 * <p>Printed are R_z = [l/d m/d; −m/d l/d], which turns the axis away from the x axis instead of
 * towards it, and R_y = [d −n; n d] in the coordinates x and z, which would bring it onto x and not
 * onto z. Where d = 0 it divides 0 by 0.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, p. 21,
 * rotation about a line.
 */
public final class SevenStepsTextbook extends SteppedAxisRotation {
    @Override
    List<AxisStep> steps(double[] through, double[] k, double degrees) {
        double d = Math.sqrt(k[0] * k[0] + k[1] * k[1]);
        var aboutZ = new AxisStep.Turn("turn about z by θ", 0, 1, k[1] / d, k[0] / d);
        var aboutY = new AxisStep.Turn("turn about y by φ", 2, 0, k[2], d);
        Angle by = Angle.ofDegrees(degrees);
        return List.of(
                new AxisStep.Shift("move the axis through the origin", through, -1),
                aboutZ,
                aboutY,
                new AxisStep.Turn("turn about z by the angle", 0, 1, by.sin(), by.cos()),
                aboutY.back("turn about y by −φ"),
                aboutZ.back("turn about z by −θ"),
                new AxisStep.Shift("move back", through, 1));
    }
}
