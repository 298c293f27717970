package rasterlab.app.study;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.table.TableCellRenderer;

/** Names of columns that stand upright, so that a column is as narrow as its sign. */
final class UprightHeader extends JComponent implements TableCellRenderer {
    private static final long serialVersionUID = 1L;

    private static final int MARGIN = 8;

    /** The most of the table's height that names may take before their type gets smaller. */
    private static final double SHARE = 0.5;

    private static final double SMALLEST = 0.6;

    private final boolean lying;
    private String name = "";

    /**
     * @param lying whether this name lies, at the foot of a header that is high for the others
     */
    UprightHeader(boolean lying) {
        this.lying = lying;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean on, boolean focused, int row, int column) {
        name = String.valueOf(value);
        setFont(table.getFont());
        int longest = longest(table);
        double most = SHARE * room(table) - 2 * MARGIN;
        if (longest > most) {
            double smaller = Math.max(SMALLEST, most / longest);
            setFont(getFont().deriveFont((float) (getFont().getSize2D() * smaller)));
            longest = longest(table);
        }
        int width = table.getColumnModel().getColumn(column).getPreferredWidth();
        setPreferredSize(new Dimension(width, longest + 2 * MARGIN));
        return this;
    }

    private int longest(JTable table) {
        var metrics = getFontMetrics(getFont());
        int longest = metrics.getHeight();
        for (int i = 0; !lying && i < table.getColumnCount(); i++)
            longest = Math.max(longest, metrics.stringWidth(table.getColumnName(i)));
        return longest;
    }

    /** Height of what scrolls the table; without end where nothing does. */
    private static double room(JTable table) {
        Component scroll = SwingUtilities.getAncestorOfClass(JScrollPane.class, table);
        return scroll == null || scroll.getHeight() == 0
                ? Double.POSITIVE_INFINITY
                : scroll.getHeight();
    }

    /** Height of a letter that goes neither up nor down, as most of a name's do. */
    private double smallLetter(Graphics2D g) {
        return getFont()
                .createGlyphVector(g.getFontRenderContext(), "x")
                .getVisualBounds()
                .getHeight();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("TableHeader.bottomSeparatorColor"));
        g.drawLine(0, getHeight() - 1, getWidth(), getHeight() - 1);
        g.setFont(getFont());
        g.setColor(UIManager.getColor("TableHeader.foreground"));
        if (lying) {
            int left = UIScale.scale(UIManager.getInsets("Table.cellMargins").left);
            g.drawString(name, left, getHeight() - MARGIN);
        } else {
            g.translate((getWidth() + smallLetter(g)) / 2, getHeight() - MARGIN);
            g.rotate(-Math.PI / 2);
            g.drawString(name, 0, 0);
        }
        g.dispose();
    }
}
