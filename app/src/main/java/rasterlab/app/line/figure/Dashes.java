package rasterlab.app.line.figure;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** Patterns of strokes and gaps, in widths of the pen. */
public enum Dashes {
    SOLID,
    DASHED(3, 2),
    /** Strokes shorter than the pen is wide; with a round pen, dots. */
    DOTTED(0.25, 1.75),
    DASH_DOT(4, 2, 0.25, 2);

    private final double[] widths;

    Dashes(double... widths) {
        this.widths = widths;
    }

    /** Lengths in pixels of a stroke, a gap, a stroke, …, for a pen of that width in pixels. */
    double[] lengths(double width) {
        var lengths = new double[widths.length];
        for (int i = 0; i < lengths.length; i++) lengths[i] = Math.max(0.25, widths[i] * width);
        return lengths;
    }

    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static Dashes coded(String code) {
        return Named.find("dashes", code, List.of(values()), Dashes::code);
    }
}
