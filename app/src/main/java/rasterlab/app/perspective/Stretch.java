package rasterlab.app.perspective;

import java.util.Locale;

/**
 * A stretch of distances z'/dz' over which γ behaves alike.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "simple
 * perspective transformation": γ runs away for z' below 2 to 3 dz'.
 */
public enum Stretch {
    RUNS_AWAY(2),
    EDGE(3),
    CALM(Double.POSITIVE_INFINITY);

    private final double end;

    Stretch(double end) {
        this.end = end;
    }

    /** The end of the stretch, in units of dz', where the next one begins. */
    public double end() {
        return end;
    }

    /**
     * @param distance z'/dz', above 0
     */
    public static Stretch of(double distance) {
        for (Stretch stretch : values()) if (distance < stretch.end) return stretch;
        throw new IllegalArgumentException("distance must be finite, got " + distance);
    }

    /** The name of the stretch in files and keys of texts. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
