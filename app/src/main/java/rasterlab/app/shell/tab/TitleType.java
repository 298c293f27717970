package rasterlab.app.shell.tab;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.util.Map;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;

/**
 * The type of the tabs' titles: that of labels, or smaller where that saves a row; smaller than
 * {@link #LEAST} in no case.
 */
final class TitleType {
    /** Height of the strip of one row, in view units before scaling; more rows share it. */
    private static final int HIGH = 40;

    private static final int MOST = 3;

    /**
     * Smaller titles, as shares of the labels' size, go into a second row, which is as low as half
     * of the first, and a third one, which takes height from what the tabs show.
     */
    private static final float[] SMALLEST = {0.85f, 0.6f};

    /** No smaller than so many view units, if labels are not. */
    private static final float LEAST = 14;

    private static final float STEP = 0.5f;

    private TitleType() {}

    /** Sets titles and what is around them by the pane's width. */
    static void fit(JTabbedPane pane) {
        Font label = UIManager.getFont("Label.font");
        float whole = label.getSize2D();
        float least = Math.min(whole, LEAST);
        int rows = 1;
        while (rows < MOST && rows(pane, label, Math.max(least, SMALLEST[rows - 1] * whole)) > rows)
            rows++;
        float size = whole;
        while (size > least && rows(pane, label, size) > rows) size = Math.max(least, size - STEP);
        if (pane.getFont().getSize2D() == size && height(rows).equals(height(pane))) return;
        pane.setFont(label.deriveFont(size));
        pane.putClientProperty("JTabbedPane.tabHeight", height(rows));
        pane.putClientProperty(
                "FlatLaf.style", Map.of("tabInsets", insets(size / whole, rows > 1)));
    }

    private static Integer height(int rows) {
        return HIGH / rows;
    }

    private static Object height(JTabbedPane pane) {
        return pane.getClientProperty("JTabbedPane.tabHeight");
    }

    private static int wide(JTabbedPane pane, String end) {
        return pane.getClientProperty("JTabbedPane." + end + "Component") instanceof Component part
                ? part.getPreferredSize().width
                : 0;
    }

    /** How many rows titles of that size take. */
    private static int rows(JTabbedPane pane, Font label, float size) {
        int room = pane.getWidth() - wide(pane, "leading") - wide(pane, "trailing");
        FontMetrics metrics = pane.getFontMetrics(label.deriveFont(size));
        Insets around = UIScale.scale(insets(size / label.getSize2D(), true));
        int rows = 1;
        int taken = 0;
        for (int i = 0; i < pane.getTabCount(); i++) {
            int wide = metrics.stringWidth(pane.getTitleAt(i)) + around.left + around.right;
            if (taken > 0 && taken + wide > room) {
                rows++;
                taken = 0;
            }
            taken += wide;
        }
        return rows;
    }

    /**
     * The insets as the theme has them, before scaling; with smaller type, or more rows, they are
     * smaller.
     */
    private static Insets insets(float share, boolean low) {
        Insets usual = UIManager.getInsets("TabbedPane.tabInsets");
        int beside = Math.round(usual.left * share);
        int above = low ? usual.top / 4 : usual.top;
        return new Insets(above, beside, above, beside);
    }
}
