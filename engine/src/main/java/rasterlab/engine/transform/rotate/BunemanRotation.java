package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * Three multiplications per turn by t = tan(θ/2), for every angle: beyond 90° the point is turned
 * by 180° first, which only changes its signs, and by θ − 180° then, so that |t| ≤ 1.
 *
 * <p>x' = x − T·sin θ and y' = x'·t + T with T = y + x·t are three shears of area 1: the radius
 * does not run away.
 *
 * <p>Source: O. Buneman's formula in A. V. Kazantsev, Foundations of computer graphics for
 * programmers, Kazan, 2005, ch. 3; A. Paeth, A fast algorithm for general raster rotation, Graphics
 * Interface 1986, pp. 77–81.
 */
final class BunemanRotation extends CountedRotation implements SteppedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        double rest = rest(degrees);
        loops.shear(halfTangent(rest), Angle.ofDegrees(rest).sin(), times, points);
        // Changing signs commutes with turning, so all the half turns can be done at once.
        if (signsChange(degrees, times))
            for (int i = 0; i < points.length; i++) points[i] = -points[i];
    }

    /** The rest of the angle without half turns, in −90°..90°. */
    private static double rest(double degrees) {
        return Math.IEEEremainder(Math.IEEEremainder(degrees, 360), 180);
    }

    private static double halfTangent(double rest) {
        return Math.tan(Math.toRadians(rest) / 2);
    }

    private static boolean signsChange(double degrees, int times) {
        double within = Math.IEEEremainder(degrees, 360);
        return Math.abs(within - rest(degrees)) == 180 && times % 2 == 1;
    }

    @Override
    public TurnWalk walk(double degrees, int times, double x, double y) {
        require(degrees, times, new double[] {x, y});
        double rest = rest(degrees);
        return new ShearWalk(
                halfTangent(rest),
                Angle.ofDegrees(rest).sin(),
                signsChange(degrees, times),
                times,
                x,
                y);
    }
}
