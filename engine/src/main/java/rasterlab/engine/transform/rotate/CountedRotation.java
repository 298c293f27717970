package rasterlab.engine.transform.rotate;

import rasterlab.contract.PlaneRotation;
import rasterlab.engine.transform.Arithmetic;
import rasterlab.engine.transform.Coordinates;

/** A method whose work can be counted. */
abstract class CountedRotation implements PlaneRotation {
    @Override
    public final void rotate(double degrees, int times, double[] points) {
        rotate(Arithmetic.PLAIN, degrees, times, points);
    }

    final void rotate(Arithmetic on, double degrees, int times, double[] points) {
        require(degrees, times, points, Coordinates.LARGEST);
        if (times > 0) turn(on, degrees, times, points);
    }

    /**
     * @param times at least 1
     */
    abstract void turn(Arithmetic on, double degrees, int times, double[] points);

    static void require(double degrees, int times, double[] points, double largest) {
        if (!Double.isFinite(degrees))
            throw new IllegalArgumentException("degrees must be a finite number, got " + degrees);
        if (times < 0 || times > MOST_TIMES)
            throw new IllegalArgumentException(
                    "times must be from 0 to " + MOST_TIMES + ", got " + times);
        Coordinates.require(points, 2, largest);
    }
}
