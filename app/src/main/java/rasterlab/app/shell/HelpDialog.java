package rasterlab.app.shell;

import java.awt.Font;
import java.awt.Window;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;

/** Shows what can be done in a tab, beside the window, which goes on meanwhile. */
final class HelpDialog extends JDialog {
    private static final long serialVersionUID = 1L;

    private static final int MOST_HIGH = 640;

    HelpDialog(Window owner, HelpText help) {
        super(owner, help.title());
        setName("help");
        setDefaultCloseOperation(DISPOSE_ON_CLOSE);
        JComponent rows = rows(help);
        // Something must have the keyboard, by which the rows scroll and the dialog goes.
        rows.setFocusable(true);
        var scroll = new JScrollPane(rows);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.getVerticalScrollBar().setUnitIncrement(16);
        setContentPane(scroll);
        for (String key : new String[] {"ESCAPE", "F1"})
            KeyBinding.within(getRootPane(), KeyStroke.getKeyStroke(key), this::dispose);
        pack();
        if (getHeight() > MOST_HIGH)
            setSize(getWidth() + scroll.getVerticalScrollBar().getPreferredSize().width, MOST_HIGH);
        setLocationRelativeTo(owner);
        rows.requestFocusInWindow();
    }

    private static JComponent rows(HelpText help) {
        var rows = new JPanel(new MigLayout("insets 12 16 14 16, gap 18 5, wrap 2", "[][]", ""));
        for (HelpText.Section section : help.sections()) {
            var heading = new JLabel(section.heading());
            heading.putClientProperty("FlatLaf.styleClass", "h4");
            rows.add(heading, "span 2, gaptop " + (rows.getComponentCount() == 0 ? 0 : 10));
            for (HelpText.HelpEntry way : section.ways()) {
                var by = new JLabel(way.by());
                by.setFont(by.getFont().deriveFont(Font.BOLD));
                rows.add(by, "aligny top");
                rows.add(new JLabel(way.does()));
            }
        }
        return rows;
    }
}
