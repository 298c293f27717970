package rasterlab.contract;

/**
 * The cone that a spot light shines into: its light is multiplied by cosᵉ of the angle to the
 * cone's axis, e being the exponent, and is 0 outside.
 *
 * <p>Within rounding of the cone's rim a point may be taken for either.
 *
 * @param direction x, y, z of the axis, away from the light; of any length above 0
 * @param cutoff half the opening in degrees, 0 to 90, or 180 for a light without a cone
 * @param exponent 0 (even) to 128 (gathered about the axis)
 */
public record SpotCone(double[] direction, double cutoff, double exponent) {
    /** The highest exponent. */
    public static final double HIGHEST_EXPONENT = 128;

    public SpotCone {
        direction = Numbers.vector("direction", direction);
        if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
            throw new IllegalArgumentException("direction must not be zero, got (0, 0, 0)");
        if (!(cutoff >= 0 && cutoff <= 90 || cutoff == 180))
            throw new IllegalArgumentException(
                    "cutoff must be from 0 to 90 degrees, or 180 for none, got " + cutoff);
        if (!(exponent >= 0 && exponent <= HIGHEST_EXPONENT))
            throw new IllegalArgumentException("exponent must be from 0 to 128, got " + exponent);
    }

    /** A light that shines all around. */
    public static SpotCone none() {
        return new SpotCone(new double[] {0, 0, -1}, 180, 0);
    }

    /** Whether there is a cone at all. */
    public boolean shinesAllAround() {
        return cutoff == 180;
    }
}
