package rasterlab.engine.transform;

/**
 * An angle as its sine and cosine.
 *
 * <p>From degrees, whole quarters are taken off first, which is exact: sin 180° is 0 and not
 * 1.2·10⁻¹⁶, and 10⁹ turns are as good as none. The rest is at most 45°, where the conversion to
 * radians and the functions together err by no more than 2 ulp.
 */
public record Angle(double sin, double cos) {
    /**
     * @throws IllegalArgumentException if {@code degrees} is not finite
     */
    public static Angle ofDegrees(double degrees) {
        if (!Double.isFinite(degrees))
            throw new IllegalArgumentException(
                    "the angle must be a finite number of degrees, got " + degrees);
        double turn = Math.IEEEremainder(degrees, 360);
        int quarters = (int) Math.rint(turn / 90);
        double rest = Math.toRadians(turn - 90 * quarters);
        double s = Math.sin(rest);
        double c = Math.cos(rest);
        return switch (quarters & 3) {
            case 0 -> new Angle(s, c);
            case 1 -> new Angle(c, -s);
            case 2 -> new Angle(-s, -c);
            default -> new Angle(-c, s);
        };
    }

    public static Angle ofRadians(double radians) {
        return new Angle(Math.sin(radians), Math.cos(radians));
    }

    /** This angle the other way round. */
    public Angle negated() {
        return new Angle(-sin, cos);
    }
}
