package rasterlab.engine.transform.rotate;

/**
 * Three multiplications per turn by t = tan(θ/2), as printed: T = y + x·t, x' = x − T·sin θ, y' =
 * x'·t + T.
 *
 * <p>Close to 180° t runs away and y' becomes a difference of huge numbers: at 180° itself the
 * double next to tan 90° is 1.6·10¹⁶, and nothing of y is left.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 3,
 * formula of O. Buneman.
 */
final class BunemanTextbookRotation extends CountedRotation implements SteppedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        double theta = theta(degrees);
        loops.shear(Math.tan(theta / 2), Math.sin(theta), times, points);
    }

    private static double theta(double degrees) {
        return Math.toRadians(Math.IEEEremainder(degrees, 360));
    }

    @Override
    public TurnWalk walk(double degrees, int times, double x, double y) {
        require(degrees, times, new double[] {x, y});
        double theta = theta(degrees);
        return new ShearWalk(Math.tan(theta / 2), Math.sin(theta), false, times, x, y);
    }
}
