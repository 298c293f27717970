package rasterlab.app.clip.outcome;

import java.util.Locale;
import rasterlab.app.canvas.Shown;

/** Region codes and decisions as the picture writes them. */
public final class Codes {
    private Codes() {}

    /** A code's bits, the highest first. */
    public static String bits(int code, int width) {
        String bits = Integer.toBinaryString(code);
        return "0".repeat(Math.max(0, width - bits.length())) + bits;
    }

    /** The value that a step decided by: a code, or t; "" where there was nothing to decide. */
    public static String decision(boolean byCode, ClipStep step, Locale locale) {
        if (Double.isNaN(step.decision())) return "";
        return byCode
                ? bits((int) step.decision(), 4)
                : "t = " + Shown.number(step.decision(), locale);
    }
}
