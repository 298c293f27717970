package rasterlab.app.canvas.lab;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.language.Texts;

/**
 * The one layout of every lab: hazard chips above the stage, the stage left and largest, the
 * inspector on the right, which can be hidden, the timeline below. In large type an inspector that
 * would take nearly half of the lab is hidden until it is asked for.
 */
public final class LabLayout extends JPanel {
    private static final long serialVersionUID = 1L;

    /**
     * Width of the inspector at 100 %; more where a list of choices or the buttons below need more,
     * and at most half of the lab, unless the buttons do: what then does not fit is scrolled.
     */
    public static final int INSPECTOR = 352;

    /** The inspector's width where lists stand below their labels. */
    private static final int STACKED = 336;

    private static final String HIDDEN = "Rasterlab.inspectorsHidden";

    /** The share of the lab from which on an inspector in large type crowds the stage. */
    private static final double CROWD = 0.45;

    /** Whether the inspectors were asked for where they crowd the stage. */
    private static final String CROWDING = "Rasterlab.inspectorsCrowd";

    private final JPanel column;
    private final InspectorSwitch hiding;
    private final StageGuide guide;
    private final boolean large = LargeType.now();
    private final int wide;

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
                        "insets 8 10 10 0, gap 0 8, hidemode 3",
                        "[grow,fill]1[fill,shrink 0]1[fill,shrink 0]",
                        "[][grow,fill][]"));
        column = column(inspector, actions);
        hiding = new InspectorSwitch(inspector.language(), () -> toggle(stage));
        // Each part has its own cell: a hidden one would otherwise take the end of its row along.
        add(chips, "cell 0 0, wmin 0, growx");
        add(hiding, "cell 1 0 1 3, growy");
        int usual = UIScale.scale(inspector.stacked() ? STACKED : INSPECTOR);
        int buttons = actions.getMinimumSize().width;
        wide = Math.max(usual, Math.max(needed(inspector), buttons));
        String width = "w 0:%dpx:max(50%%,%dpx), ".formatted(wide, buttons);
        add(column, width + "cell 2 0 1 3, growy, hmin 0");
        Optional<Actions> undo =
                Optional.of(actions).filter(Actions.class::isInstance).map(Actions.class::cast);
        guide =
                new StageGuide(
                        stage,
                        Texts.of("canvas", inspector.language()),
                        undo.flatMap(Actions::history));
        undo.ifPresent(each -> each.whenChanged(guide::done));
        if (timeline instanceof StepPlayer player) player.whenUsed(guide::done);
        add(guide, "cell 0 1, wmin 100, hmin 100");
        add(timeline, "cell 0 2, wmin 0, growx");
        refresh();
    }

    @Override
    public void doLayout() {
        refresh();
        super.doLayout();
    }

    /** The sentences on the stage and the strip over it. */
    public StageGuide guide() {
        return guide;
    }

    /** Whether the labs show their inspectors. On the event thread. */
    public static boolean showsInspectors() {
        return !UIManager.getBoolean(HIDDEN);
    }

    /** Shows or hides the inspectors of every lab made from now on. On the event thread. */
    public static void showInspectors(boolean shown) {
        UIManager.put(HIDDEN, !shown);
    }

    /** Shows inspectors, or hides them, where they crowd the stage. On the event thread. */
    public static void showCrowdingInspectors(boolean shown) {
        UIManager.put(CROWDING, shown);
    }

    /**
     * Shows or hides the inspector in every lab of the window at once, so that no tab looks
     * otherwise than the one before.
     */
    private void toggle(JComponent stage) {
        boolean shown = !column.isVisible();
        if (crowded()) showCrowdingInspectors(shown);
        if (shown || !crowded()) showInspectors(shown);
        Component window = SwingUtilities.getRoot(this);
        refreshAll(window instanceof Container all ? all : this);
        if (!column.isVisible() && !stage.requestFocusInWindow()) hiding.requestFocusInWindow();
    }

    private static void refreshAll(Container container) {
        if (container instanceof LabLayout lab) {
            lab.refresh();
            lab.revalidate();
        }
        for (Component each : container.getComponents())
            if (each instanceof Container inner) refreshAll(inner);
    }

    private void refresh() {
        boolean shown = showsInspectors() && (!crowded() || UIManager.getBoolean(CROWDING));
        column.setVisible(shown);
        hiding.refresh(shown);
    }

    private boolean crowded() {
        return large && getWidth() > 0 && wide > CROWD * getWidth();
    }

    /** The width needed, in view units as they are, where INSPECTOR still grows with the font. */
    private static int needed(Inspector inspector) {
        int bar = UIScale.scale(UIManager.getInt("ScrollBar.width"));
        return inspector.getMinimumSize().width + bar;
    }

    /**
     * A column laid out by a layout that asks its parts for no more sizes than it needs: MigLayout
     * asks for each several times, and one in another as often as the product of both.
     */
    private static JPanel column(Inspector inspector, JComponent actions) {
        var column = new JPanel(new BorderLayout(0, 8));
        column.add(scrolled(inspector));
        column.add(actions, BorderLayout.SOUTH);
        return column;
    }

    /** The bar keeps its place when there is nothing to scroll, so that no edge moves. */
    private static JScrollPane scrolled(Inspector inspector) {
        var scroll =
                new JScrollPane(
                        inspector,
                        ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                        ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setName("inspector.scroll");
        return scroll;
    }
}
