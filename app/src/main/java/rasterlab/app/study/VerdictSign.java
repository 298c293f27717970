package rasterlab.app.study;

import java.awt.Color;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.engine.study.Verdict;

/** A verdict as one sign and a colour, which say the same. */
enum VerdictSign {
    EXACT("✓", MethodColors.GREEN),
    DEGRADED("≈", MethodColors.ORANGE),
    WRONG("✗", MethodColors.VERMILLION),
    REFUSED("⊘", MethodColors.GREY),
    ENDLESS("∞", MethodColors.PURPLE),
    CRASHED("†", MethodColors.PURPLE);

    private final String sign;
    private final Color colour;

    VerdictSign(String sign, Color colour) {
        this.sign = sign;
        this.colour = colour;
    }

    static VerdictSign of(Verdict.Kind kind) {
        return valueOf(kind.name());
    }

    String sign() {
        return sign;
    }

    Color ink(Color ground) {
        return MethodColors.textOn(ground, colour);
    }
}
