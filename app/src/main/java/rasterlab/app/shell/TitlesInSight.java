package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;

/**
 * Keeps the chosen tab's title whole: arrows that come and go beside the titles would cut it off.
 */
final class TitlesInSight extends ComponentAdapter {
    private final JTabbedPane pane;

    /** Whether the user scrolled the titles since the tab was chosen. */
    private boolean lookedAround;

    private TitlesInSight(JTabbedPane pane) {
        this.pane = pane;
    }

    static void keep(JTabbedPane pane) {
        var keeper = new TitlesInSight(pane);
        for (Component part : pane.getComponents()) {
            if (part instanceof JViewport titles) {
                titles.setFocusable(false);
                titles.addComponentListener(keeper);
            }
            if (part instanceof JButton arrow)
                arrow.addActionListener(e -> keeper.lookedAround = true);
        }
        pane.addMouseWheelListener(e -> keeper.lookedAround = true);
        pane.addChangeListener(e -> keeper.lookedAround = false);
    }

    @Override
    public void componentResized(ComponentEvent e) {
        if (lookedAround) return;
        var titles = (JViewport) e.getComponent();
        Rectangle title = pane.getBoundsAt(pane.getSelectedIndex());
        var all = (JComponent) titles.getView();
        all.scrollRectToVisible(SwingUtilities.convertRectangle(pane, title, all));
    }
}
