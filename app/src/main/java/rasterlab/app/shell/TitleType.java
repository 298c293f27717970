package rasterlab.app.shell;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.util.Map;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;

/**
 * The type of the tabs' titles: that of labels where all titles have room beside each other, else
 * smaller. Who teaches from afar looks at the picture; the titles are for the one at the mouse.
 */
final class TitleType {
    /** No smaller than so many view units, if labels are not. */
    private static final float LEAST = 14;

    private static final float STEP = 0.5f;

    private TitleType() {}

    /** Sets titles and what is around them by the pane's width. */
    static void fit(JTabbedPane pane) {
        Font label = UIManager.getFont("Label.font");
        float whole = label.getSize2D();
        float least = Math.min(whole, LEAST);
        int room = pane.getWidth() - wide(pane, "leading") - wide(pane, "trailing");
        float size = whole;
        while (size > least && needed(pane, label, size, whole) > room)
            size = Math.max(least, size - STEP);
        if (pane.getFont().getSize2D() == size) return;
        pane.setFont(label.deriveFont(size));
        pane.putClientProperty("FlatLaf.style", Map.of("tabInsets", insets(size / whole)));
    }

    private static int wide(JTabbedPane pane, String end) {
        return pane.getClientProperty("JTabbedPane." + end + "Component") instanceof Component part
                ? part.getPreferredSize().width
                : 0;
    }

    private static int needed(JTabbedPane pane, Font label, float size, float whole) {
        FontMetrics metrics = pane.getFontMetrics(label.deriveFont(size));
        Insets around = UIScale.scale(insets(size / whole));
        int separator = UIScale.scale(1);
        int needed = 0;
        for (int i = 0; i < pane.getTabCount(); i++)
            needed +=
                    metrics.stringWidth(pane.getTitleAt(i))
                            + around.left
                            + around.right
                            + separator;
        return needed;
    }

    /** As the theme has them, before scaling; with smaller type they are smaller too. */
    private static Insets insets(float share) {
        Insets usual = UIManager.getInsets("TabbedPane.tabInsets");
        int beside = Math.round(usual.left * share);
        return new Insets(usual.top, beside, usual.bottom, beside);
    }
}
