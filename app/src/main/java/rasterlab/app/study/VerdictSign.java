package rasterlab.app.study;

import java.awt.Color;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.engine.study.Verdict;

/** A verdict as one sign and a colour, which say the same. */
enum VerdictSign {
    EXACT("✓", MethodColors.GREEN),
    DEGRADED("≈", MethodColors.ORANGE),
    WRONG("✗", MethodColors.VERMILLION),
    REFUSED("⊘", MethodColors.GRAY),
    ENDLESS("∞", MethodColors.PURPLE),
    CRASHED("†", MethodColors.PURPLE);

    private final String sign;
    private final Color color;

    VerdictSign(String sign, Color color) {
        this.sign = sign;
        this.color = color;
    }

    static VerdictSign of(Verdict.Kind kind) {
        return valueOf(kind.name());
    }

    String sign() {
        return sign;
    }

    Color ink(Color ground) {
        return MethodColors.textOn(ground, color);
    }
}
