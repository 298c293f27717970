package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * n turns by θ are one turn by n·θ: the angles are added, not the roundings.
 *
 * <p>n·θ has at most 77 bits; the product's rounding error is recovered by a fused multiply-add,
 * and taking off whole turns is exact. What is left is a double with an error below its last bit.
 *
 * <p>Source: T. J. Dekker, A floating-point technique for extending the available precision,
 * Numerische Mathematik 18, 1971, pp. 224–242 (exact products).
 */
final class TotalAngleRotation extends CountedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        double within = Math.IEEEremainder(degrees, 360);
        double product = within * times;
        double lost = Math.fma(within, times, -product);
        Angle total = Angle.ofDegrees(Math.IEEEremainder(product, 360) + lost);
        loops.turn(total, 1, points);
    }
}
