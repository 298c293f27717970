package rasterlab.engine.transform.rotate;

import rasterlab.contract.PlaneRotation;
import rasterlab.engine.transform.Coordinates;

/** A method whose work can be counted. */
abstract class CountedRotation implements PlaneRotation {
    private static final TurnLoops PLAIN = new TurnLoops();

    @Override
    public final void rotate(double degrees, int times, double[] points) {
        rotate(PLAIN, degrees, times, points);
    }

    final void rotate(TurnLoops loops, double degrees, int times, double[] points) {
        require(degrees, times, points);
        if (times > 0) turn(loops, degrees, times, points);
    }

    /** Passes if the method can turn these points. */
    void require(double degrees, int times, double[] points) {
        require(degrees, times, points, Coordinates.LARGEST);
    }

    /**
     * @param times at least 1
     */
    abstract void turn(TurnLoops loops, double degrees, int times, double[] points);

    static void require(double degrees, int times, double[] points, double largest) {
        if (!Double.isFinite(degrees))
            throw new IllegalArgumentException("degrees must be a finite number, got " + degrees);
        if (times < 0 || times > MOST_TIMES)
            throw new IllegalArgumentException(
                    "times must be from 0 to " + MOST_TIMES + ", got " + times);
        Coordinates.require(points, 2, largest);
    }
}
