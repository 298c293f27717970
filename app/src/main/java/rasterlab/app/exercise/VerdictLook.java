package rasterlab.app.exercise;

import java.awt.Color;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.canvas.StageColours;
import rasterlab.exercises.score.GradingVerdict;

/** How a verdict looks: by a sign and by a colour. */
final class VerdictLook {
    private VerdictLook() {}

    /** ✓ right, ✗ not, · not tried. */
    static String sign(String verdict) {
        if (verdict.isEmpty() || verdict.equals(GradingVerdict.NOT_MEASURED.code())) return "·";
        return right(verdict) ? "✓" : "✗";
    }

    /** Stands out from the ground of the present theme. */
    static Color colour(String verdict) {
        var ground = StageColours.now().ground();
        Color own = right(verdict) ? MethodColours.GREEN : MethodColours.VERMILLION;
        return MethodColours.edgeOn(ground, own);
    }

    private static boolean right(String verdict) {
        return verdict.equals(GradingVerdict.OK.code());
    }
}
