package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * Sines from a table in steps of 1°: exact for whole degrees, otherwise off by up to half a degree
 * in every turn.
 *
 * <p>Source: Kazantsev, course text on computer graphics, chapter 3, "efficiency of computing".
 */
final class TableRotation extends CountedRotation {
    private static final double[] SINES = sines();

    private static double[] sines() {
        var sines = new double[360 + 90];
        for (int i = 0; i < sines.length; i++) sines[i] = Angle.ofDegrees(i).sin();
        return sines;
    }

    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        int nearest = (int) Math.rint(Math.IEEEremainder(degrees, 360));
        int row = Math.floorMod(nearest, 360);
        var by = new Angle(SINES[row], SINES[row + 90]);
        loops.turn(by, times, points);
    }
}
