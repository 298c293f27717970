package rasterlab.app.exercise.outcome;

import java.awt.Color;
import java.util.Set;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.exercises.score.GradingVerdict;

/** How a verdict looks: by a sign and by a colour. */
public final class VerdictLook {
    private static final Set<String> UNTRIED =
            Set.of("", GradingVerdict.NOT_MEASURED.code(), GradingVerdict.NOT_RUN.code());

    private VerdictLook() {}

    /** ✓ right, ✗ not, · not tried. */
    public static String sign(String verdict) {
        if (!tried(verdict)) return "·";
        return right(verdict) ? "✓" : "✗";
    }

    public static boolean tried(String verdict) {
        return !UNTRIED.contains(verdict);
    }

    /** The colour for a verdict's words on that ground. */
    public static Color color(String verdict, Color ground) {
        Color own = right(verdict) ? MethodColors.GREEN : MethodColors.VERMILLION;
        return MethodColors.textOn(ground, own);
    }

    private static boolean right(String verdict) {
        return verdict.equals(GradingVerdict.OK.code());
    }
}
