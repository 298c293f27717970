package rasterlab.app.exercise;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.UIManager;
import rasterlab.app.language.Texts;

/**
 * Statement, program and result: all in sight where the window has room for them, else one at a
 * time.
 */
final class Rooms extends JPanel {
    private static final long serialVersionUID = 1L;

    /** What all three need, in sizes of the type. */
    private static final int WIDE = 80;

    private static final int HIGH = 34;

    /** Parts of the tab, in the order of their tabs. */
    enum Room {
        STATEMENT,
        PROGRAM,
        RESULT
    }

    private final transient Texts texts;
    private final JComponent statement;
    private final JComponent program;
    private final JComponent result;
    private final JTabbedPane tabs = new JTabbedPane();
    private Room chosen = Room.STATEMENT;

    Rooms(Texts texts, JComponent statement, JComponent program, JComponent result) {
        super(new BorderLayout());
        this.texts = texts;
        this.statement = statement;
        this.program = program;
        this.result = result;
        tabs.setName("rooms");
        tabs.getAccessibleContext().setAccessibleName(texts.text("rooms"));
        tabs.addChangeListener(e -> remember());
        add(split());
    }

    private void remember() {
        if (tabs.getTabCount() == Room.values().length)
            chosen = Room.values()[tabs.getSelectedIndex()];
    }

    /** Brings that part in sight. */
    void show(Room room) {
        chosen = room;
        if (!together()) tabs.setSelectedIndex(room.ordinal());
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
        super.doLayout();
    }

    private void arrange(boolean room) {
        removeAll();
        tabs.removeAll();
        if (room) {
            add(split());
            return;
        }
        Room shown = chosen;
        tabs.addTab(texts.text("room.statement"), statement);
        tabs.addTab(texts.text("room.program"), program);
        tabs.addTab(texts.text("room.result"), result);
        tabs.setSelectedIndex(shown.ordinal());
        add(tabs);
    }

    private JComponent split() {
        var right = new JSplitPane(JSplitPane.VERTICAL_SPLIT, program, result);
        divide(right, 0.5, "split.result");
        var both = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, statement, right);
        divide(both, 0.37, "split.statement");
        return both;
    }

    private void divide(JSplitPane pane, double share, String name) {
        pane.setName(name);
        pane.getAccessibleContext().setAccessibleName(texts.text(name));
        pane.setBorder(null);
        pane.setResizeWeight(share);
        pane.getLeftComponent().setMinimumSize(UIScale.scale(new Dimension(200, 140)));
        pane.getRightComponent().setMinimumSize(UIScale.scale(new Dimension(300, 140)));
        pane.getLeftComponent().setPreferredSize(scaled(share));
        pane.getRightComponent().setPreferredSize(scaled(1 - share));
    }

    /** Sizes in the ratio of the shares, so that the first layout divides by them too. */
    private static Dimension scaled(double share) {
        return UIScale.scale(new Dimension((int) (1250 * share), (int) (700 * share)));
    }
}
