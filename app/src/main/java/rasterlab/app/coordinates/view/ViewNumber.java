package rasterlab.app.coordinates.view;

import java.util.Locale;
import rasterlab.app.coordinates.figure.SliderField.Range;
import rasterlab.engine.transform.SphericalView;

/** A number that some kinds of view have. Angles in degrees, lengths in world units. */
public enum ViewNumber {
    ANGLE_X(-90, angle()),
    ANGLE_Y(-40, angle()),
    TILT(10, angle()),
    SHIFT(-150, new Range(-2000, 2000, -400, 400, 5, false)),
    P(0.002, part()),
    Q(0.0015, part()),
    R(-1.0 / 700, part()),
    K(500, length()),
    THETA(30, angle()),
    PHI(70, angle()),
    RHO(400, new Range(SphericalView.NEAREST, 100_000, 40, 4000, 10, true)),
    D(400, length()),
    ALPHA(-30, angle()),
    BETA(20, angle()),
    EYE_X(230, place()),
    EYE_Y(-330, place()),
    EYE_Z(120, place()),
    FOVY(35, new Range(1, 179, 1, 179, 1, false)),
    SEPARATION(20, new Range(0.01, 1000, 1, 80, 1, false)),
    WIDTH(800, pixels()),
    HEIGHT(600, pixels());

    private final double first;
    private final transient Range range;

    ViewNumber(double first, Range range) {
        this.first = first;
        this.range = range;
    }

    private static Range angle() {
        return new Range(-36_000, 36_000, -180, 180, 1, false);
    }

    private static Range part() {
        return new Range(-1, 1, -0.01, 0.01, 0.0001, false);
    }

    private static Range length() {
        return new Range(0.001, 100_000, 40, 4000, 10, true);
    }

    private static Range place() {
        return new Range(-100_000, 100_000, -800, 800, 10, false);
    }

    private static Range pixels() {
        return new Range(16, 4096, 80, 1600, 10, false);
    }

    /** Lower-case name with hyphens, as controls and texts are called. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** How the lab opens. */
    double first() {
        return first;
    }

    Range range() {
        return range;
    }
}
