package rasterlab.app.exercise.panel;

import java.awt.Dimension;
import java.awt.Font;
import javax.swing.UIManager;
import rasterlab.app.canvas.lab.LargeType;

/**
 * The type of verdicts, cases and reasons beside the pictures: that of labels, in large type no
 * larger than leaves the pictures and the cases' verdicts their room.
 */
final class ResultType {
    /** Sizes of its type that a result is high and wide at least, with the pictures beside. */
    private static final int HIGH = 20;

    private static final int WIDE = 54;

    /**
     * Sizes that it is high and wide at least with the pictures below, where fewer cases are in
     * sight.
     */
    private static final int HIGH_ABOVE = 18;

    private static final int WIDE_ABOVE = 36;

    /** Share of the size of labels that the type may shrink to for more cases. */
    private static final float NEARLY = 0.85f;

    /** Smallest share of the size of labels. */
    private static final float LEAST = 0.6f;

    private ResultType() {}

    /** The type for a result of that size. */
    static Font in(Dimension result) {
        Font label = UIManager.getFont("Label.font");
        float usual = label.getSize2D();
        if (!LargeType.now()) return label;
        float beside = most(result, HIGH, WIDE);
        float most = beside >= NEARLY * usual ? beside : most(result, HIGH_ABOVE, WIDE_ABOVE);
        return label.deriveFont(Math.min(usual, Math.max(LEAST * usual, Math.max(beside, most))));
    }

    private static float most(Dimension result, int high, int wide) {
        return Math.min((float) result.height / high, (float) result.width / wide);
    }
}
