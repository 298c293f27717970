package rasterlab.engine.color;

/** Angles of colour. */
final class Hue {
    private Hue() {}

    /** The angle from 0 to below 360; {@code degrees} lies above −360 and below 360. */
    static double within(double degrees) {
        double positive = degrees < 0 ? degrees + 360 : degrees;
        // −1e-20 + 360 rounds to 360; adding 0 makes −0 positive.
        return positive >= 360 ? 0 : positive + 0.0;
    }
}
