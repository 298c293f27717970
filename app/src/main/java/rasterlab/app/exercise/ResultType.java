package rasterlab.app.exercise;

import java.awt.Dimension;
import java.awt.Font;
import javax.swing.UIManager;
import rasterlab.app.canvas.LargeType;

/**
 * The type of verdicts, cases and reasons beside the pictures: that of labels, in large type no
 * larger than leaves the pictures and the cases' verdicts their room.
 */
final class ResultType {
    /** The result is at least so many sizes of its type high. */
    private static final int HIGH = 20;

    /** The result is at least so many sizes of its type wide. */
    private static final int WIDE = 54;

    /** Of the type of labels. */
    private static final float LEAST = 0.6f;

    private ResultType() {}

    /** For a result of that size. */
    static Font in(Dimension result) {
        Font label = UIManager.getFont("Label.font");
        if (!LargeType.now()) return label;
        float most = Math.min((float) result.height / HIGH, (float) result.width / WIDE);
        float least = LEAST * label.getSize2D();
        return label.deriveFont(Math.min(label.getSize2D(), Math.max(least, most)));
    }
}
