package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * Sines from a table in steps of 1°: exact for whole degrees, otherwise off by up to half a degree
 * in every turn.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 3,
 * "efficiency of computing".
 */
final class TableRotation extends CountedRotation implements SteppedRotation {
    private static final double[] SINES = sines();

    private static double[] sines() {
        var sines = new double[360 + 90];
        for (int i = 0; i < sines.length; i++) sines[i] = Angle.ofDegrees(i).sin();
        return sines;
    }

    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        loops.turn(nearest(degrees), times, points);
    }

    private static Angle nearest(double degrees) {
        int nearest = (int) Math.rint(Math.IEEEremainder(degrees, 360));
        int row = Math.floorMod(nearest, 360);
        return new Angle(SINES[row], SINES[row + 90]);
    }

    @Override
    public TurnWalk walk(double degrees, int times, double x, double y) {
        require(degrees, times, new double[] {x, y});
        return new DirectWalk(nearest(degrees), times, x, y);
    }
}
