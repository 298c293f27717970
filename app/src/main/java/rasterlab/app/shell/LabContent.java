package rasterlab.app.shell;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import rasterlab.app.language.Texts;

/**
 * What the frame holds: the tabs, and the choice of language and theme at the end of their strip.
 */
public final class LabContent extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JTabbedPane pane = new JTabbedPane();
    private final transient List<LabTab> tabs;

    /** Whether the user scrolled the titles since the tab was chosen. */
    private boolean lookedAround;

    /**
     * @param shown name of the tab to show; an unknown one is the first
     * @param onLook told how the user wants the window to look
     */
    public LabContent(LabTabs labs, String shown, LabLook look, Consumer<LabLook> onLook) {
        super(new BorderLayout());
        Texts texts = Texts.of("shell", labs.language());
        tabs = labs.all();
        pane.setName("tabs");
        pane.getAccessibleContext().setAccessibleName(texts.text("tabs"));
        pane.putClientProperty("JTabbedPane.tabHeight", 40);
        pane.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        for (Component part : pane.getComponents()) {
            if (part instanceof JViewport titles) keepInSight(titles);
            if (part instanceof JButton arrow) arrow.addActionListener(e -> lookedAround = true);
        }
        pane.addMouseWheelListener(e -> lookedAround = true);
        for (LabTab tab : tabs) {
            int digit = (pane.getTabCount() + 1) % 10;
            pane.addTab(
                    tab.title(),
                    null,
                    new JPanel(new BorderLayout()),
                    texts.text("tab.tip", digit));
            pane.setMnemonicAt(pane.getTabCount() - 1, KeyEvent.VK_0 + digit);
        }
        labs.opening().showTabsBy(this::show);
        show(shown);
        fill();
        pane.putClientProperty("JTabbedPane.leadingComponent", brand());
        pane.putClientProperty(
                "JTabbedPane.trailingComponent", new LookControls(texts, look, onLook));
        add(pane);
        pane.addChangeListener(
                e -> {
                    lookedAround = false;
                    fill();
                    focusPicture();
                });
        pane.addMouseListener(new ChoiceOfTheShownTab());
    }

    /** The arrows that come and go beside the titles would cut off the chosen one. */
    private void keepInSight(JViewport titles) {
        titles.setFocusable(false);
        titles.addComponentListener(
                new ComponentAdapter() {
                    @Override
                    public void componentResized(ComponentEvent e) {
                        if (lookedAround) return;
                        Rectangle title = pane.getBoundsAt(pane.getSelectedIndex());
                        var all = (JComponent) titles.getView();
                        all.scrollRectToVisible(SwingUtilities.convertRectangle(pane, title, all));
                    }
                });
    }

    /** Makes the panel of the tab that is shown, unless it is there. */
    private void fill() {
        var place = (JPanel) pane.getSelectedComponent();
        if (place.getComponentCount() == 0) place.add(tabs.get(pane.getSelectedIndex()).panel());
        place.revalidate();
    }

    /**
     * Gives the keyboard to the picture of the tab that is shown. Asked twice, since Swing moves
     * the focus out of what was hidden by itself, and sometimes later than it is first asked.
     */
    void focusPicture() {
        Runnable give = () -> tabs.get(pane.getSelectedIndex()).panel().focusPicture();
        give.run();
        EventQueue.invokeLater(give);
    }

    /** Name of the tab that is shown. */
    public String shown() {
        return tabs.get(pane.getSelectedIndex()).name();
    }

    /** Shows the tab of that name; an unknown name leaves the one that is shown. */
    public void show(String tab) {
        for (int i = 0; i < tabs.size(); i++)
            if (tabs.get(i).name().equals(tab)) pane.setSelectedIndex(i);
    }

    private static JLabel brand() {
        var brand = new JLabel(new BrandIcon());
        brand.setName("brand");
        brand.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 8));
        return brand;
    }

    /** A click on the tab that is shown already changes nothing, but chooses its picture too. */
    private final class ChoiceOfTheShownTab extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent e) {
            if (pane.indexAtLocation(e.getX(), e.getY()) >= 0) focusPicture();
        }
    }
}
