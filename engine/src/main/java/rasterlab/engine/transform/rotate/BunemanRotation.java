package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * Three multiplications per turn by t = tan(θ/2), for every angle: beyond 90° the point is turned
 * by 180° first, which only changes its signs, and by θ − 180° then, so that |t| ≤ 1.
 *
 * <p>x' = x − T·sin θ and y' = x'·t + T with T = y + x·t are three shears of area 1: the radius
 * does not run away.
 *
 * <p>Source: O. Buneman's formula in Kazantsev, course text on computer graphics, chapter 3; A.
 * Paeth, A fast algorithm for general raster rotation, Graphics Interface 1986, pp. 77–81.
 */
final class BunemanRotation extends CountedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        double within = Math.IEEEremainder(degrees, 360);
        double rest = Math.IEEEremainder(within, 180);
        boolean half = Math.abs(within - rest) == 180;
        double t = Math.tan(Math.toRadians(rest) / 2);
        double sin = Angle.ofDegrees(rest).sin();
        loops.shear(t, sin, times, points);
        // Changing signs commutes with turning, so all the half turns can be done at once.
        if (half && times % 2 == 1) for (int i = 0; i < points.length; i++) points[i] = -points[i];
    }
}
