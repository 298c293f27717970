package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import rasterlab.app.language.Texts;

/**
 * Statement, program and result: all in sight where the window has room for them, else one at a
 * time.
 */
public final class ExercisePanes extends JPanel {
    private static final long serialVersionUID = 1L;

    /** The room that all three need, in sizes of the type. */
    private static final int WIDE = 80;

    private static final int HIGH = 34;

    /** Parts of the tab, in the order of their tabs. */
    public enum Room {
        STATEMENT,
        PROGRAM,
        RESULT
    }

    private final transient Texts texts;
    private final JComponent statement;
    private final JComponent program;
    private final JComponent result;
    private final JTabbedPane tabs = new JTabbedPane();
    private final transient SavedExercisePanes kept;

    /**
     * @param kept how the rooms of an earlier panel were left; takes what changes here
     */
    ExercisePanes(
            Texts texts,
            SavedExercisePanes kept,
            JComponent statement,
            JComponent program,
            JComponent result) {
        super(new BorderLayout());
        this.texts = texts;
        this.kept = kept;
        this.statement = statement;
        this.program = program;
        this.result = result;
        tabs.setName("rooms");
        tabs.getAccessibleContext().setAccessibleName(texts.text("rooms"));
        tabs.addChangeListener(e -> remember());
        add(split());
    }

    /** None is selected while the tabs are made or taken away. */
    private void remember() {
        int selected = tabs.getSelectedIndex();
        if (selected >= 0 && tabs.getTabCount() == Room.values().length)
            kept.choose(Room.values()[selected]);
    }

    /**
     * Brings that part in sight.
     *
     * @return whether another one was there instead
     */
    boolean show(Room room) {
        kept.choose(room);
        if (together() || tabs.getSelectedIndex() == room.ordinal()) return false;
        tabs.setSelectedIndex(room.ordinal());
        return true;
    }

    /** Whether all parts are in sight. */
    boolean together() {
        return tabs.getTabCount() == 0;
    }

    @Override
    public void doLayout() {
        int type = UIManager.getFont("Label.font").getSize();
        boolean room = getWidth() >= WIDE * type && getHeight() >= HIGH * type;
        if (getWidth() > 0 && room != together()) arrange(room);
        wearTitlesOfTheWindow();
        super.doLayout();
    }

    /** Titles within a tab are no larger than that of the tab, which is fitted to the window. */
    private void wearTitlesOfTheWindow() {
        var around = SwingUtilities.getAncestorOfClass(JTabbedPane.class, this);
        if (together() || around == null || around.getFont().equals(tabs.getFont())) return;
        Font usual = UIManager.getFont("TabbedPane.font");
        float share = around.getFont().getSize2D() / usual.getSize2D();
        tabs.setFont(around.getFont());
        tabs.putClientProperty(
                "JTabbedPane.tabHeight",
                Math.round(share * UIManager.getInt("TabbedPane.tabHeight")));
    }

    private void arrange(boolean room) {
        removeAll();
        tabs.removeAll();
        if (room) {
            add(split());
            return;
        }
        Room shown = kept.chosen().orElse(Room.STATEMENT);
        tabs.addTab(texts.text("room.statement"), statement);
        tabs.addTab(texts.text("room.program"), program);
        tabs.addTab(texts.text("room.result"), result);
        tabs.setSelectedIndex(shown.ordinal());
        kept.choose(shown);
        add(tabs);
    }

    private JComponent split() {
        var right = new JSplitPane(JSplitPane.VERTICAL_SPLIT, program, result);
        divide(right, 0.5, "split.result");
        var both = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, statement, right);
        divide(both, 0.37, "split.statement");
        return both;
    }

    private void divide(JSplitPane pane, double usual, String name) {
        double share = kept.share(name, usual);
        pane.setName(name);
        pane.getAccessibleContext().setAccessibleName(texts.text(name));
        pane.setBorder(null);
        pane.setResizeWeight(share);
        pane.getLeftComponent().setMinimumSize(UIScale.scale(new Dimension(200, 140)));
        pane.getRightComponent().setMinimumSize(UIScale.scale(new Dimension(300, 140)));
        pane.getLeftComponent().setPreferredSize(scaled(share));
        pane.getRightComponent().setPreferredSize(scaled(1 - share));
        pane.addPropertyChangeListener(
                JSplitPane.DIVIDER_LOCATION_PROPERTY, e -> remember(pane, name));
    }

    private void remember(JSplitPane pane, String name) {
        boolean beside = pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT;
        int room = (beside ? pane.getWidth() : pane.getHeight()) - pane.getDividerSize();
        if (room > 0) kept.divide(name, Math.min(1, (double) pane.getDividerLocation() / room));
    }

    /** Sizes in the ratio of the shares, so that the first layout divides by them too. */
    private static Dimension scaled(double share) {
        return UIScale.scale(new Dimension((int) (1250 * share), (int) (700 * share)));
    }
}
