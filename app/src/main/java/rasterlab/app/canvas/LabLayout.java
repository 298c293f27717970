package rasterlab.app.canvas;

import com.formdev.flatlaf.util.UIScale;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;

/**
 * The one layout of every lab: hazard chips above the stage, the stage left and largest, the
 * inspector on the right, the timeline below.
 */
public final class LabLayout extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Width of the inspector at 100 %; more where a list of choices needs more. */
    public static final int INSPECTOR = 352;

    /**
     * @param actions buttons that stay in sight below the inspector
     */
    public LabLayout(
            JComponent chips,
            JComponent stage,
            Inspector inspector,
            JComponent actions,
            JComponent timeline) {
        super(
                new MigLayout(
                        "insets 8 10 10 0, gap 10 8",
                        "[grow,fill][" + INSPECTOR + ":" + needed(inspector) + "px,fill,shrink 0]",
                        "[][grow,fill][]"));
        add(chips, "wmin 0, growx");
        add(column(inspector, actions), "spany 3, growy, wrap, hmin 0");
        add(stage, "wmin 100, hmin 100, wrap");
        add(timeline, "wmin 0, growx");
    }

    /** In view units as they are, where INSPECTOR still grows with the font. */
    private static int needed(Inspector inspector) {
        int bar = UIScale.scale(UIManager.getInt("ScrollBar.width"));
        return inspector.getMinimumSize().width + bar;
    }

    private static JPanel column(Inspector inspector, JComponent actions) {
        var column =
                new JPanel(
                        new MigLayout("insets 0, gap 0 8, wrap 1", "[grow,fill]", "[grow,fill][]"));
        column.add(scrolled(inspector), "hmin 0");
        column.add(actions);
        return column;
    }

    /** The bar keeps its place when there is nothing to scroll, so that no edge moves. */
    private static JScrollPane scrolled(Inspector inspector) {
        var scroll =
                new JScrollPane(
                        inspector,
                        ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                        ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setName("inspector.scroll");
        return scroll;
    }
}
