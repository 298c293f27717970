package rasterlab.app.shell;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JSeparator;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;

/**
 * Components that nobody sees. Whichever panel is made first, most of the time of each of its parts
 * would go into the first use of a kind of component; here that is spread over events.
 */
final class FirstComponents {
    private FirstComponents() {}

    /** Each in an event of its own. */
    static List<Runnable> uses() {
        return Stream.<Runnable>of(
                        () -> use(new JButton("a")),
                        () -> use(new JLabel("a")),
                        () -> use(new JTextField("a")),
                        () -> use(new JScrollPane(new JList<>(new String[] {"a"}))),
                        () -> use(new JPopupMenu()),
                        () -> use(new JComboBox<>(new String[] {"a"})),
                        () -> use(new JSlider()),
                        () -> use(new JSpinner()),
                        () -> use(row()),
                        () -> use(new JEditorPane("text/html", "")),
                        () -> use(page()),
                        () -> use(tabs()))
                .toList();
    }

    private static JPanel row() {
        var row = new JPanel(new MigLayout("insets 0, wrap 2", "[pref!]8[grow,fill]"));
        row.add(new JCheckBox("a"), "span 2");
        row.add(new JSeparator(), "span 2, growx, gaptop 6, wmin 0");
        return row;
    }

    private static JEditorPane page() {
        return new JEditorPane(
                "text/html",
                "<html><body><p style='margin: 0 0 5 0'><b>a</b> b</p>"
                        + "<table><tr><td align=right nowrap>a</td></tr></table></body></html>");
    }

    private static JTabbedPane tabs() {
        var tabs = new JTabbedPane(JTabbedPane.TOP, JTabbedPane.SCROLL_TAB_LAYOUT);
        tabs.addTab("a", new JPanel());
        return tabs;
    }

    private static void use(JComponent component) {
        Dimension size = component.getPreferredSize();
        component.getMinimumSize();
        component.setSize(Math.max(1, size.width), Math.max(1, size.height));
        component.doLayout();
        var picture =
                new BufferedImage(
                        component.getWidth(), component.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        component.paint(graphics);
        graphics.dispose();
    }
}
