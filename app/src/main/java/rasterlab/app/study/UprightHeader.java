package rasterlab.app.study;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.table.TableCellRenderer;

/**
 * Names of columns that stand upright, so that a column is as narrow as its sign. Where they would
 * take too much of the table's height they are folded into two lines, then get smaller.
 */
final class UprightHeader extends JComponent implements TableCellRenderer {
    private static final long serialVersionUID = 1L;

    private static final int MARGIN = 8;

    /** The most of the table's height that names may take. */
    private static final double SHARE = 0.6;

    private static final double SMALLEST = 0.6;

    /** The most of a column's width that a line of a folded name takes. */
    private static final double ACROSS = 0.48;

    private final boolean lying;
    private List<String> lines = List.of();

    /**
     * @param lying whether this name lies, at the foot of a header that is high for the others
     */
    UprightHeader(boolean lying) {
        this.lying = lying;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean on, boolean focused, int row, int column) {
        String name = String.valueOf(value);
        setFont(table.getFont());
        int width = table.getColumnModel().getColumn(column).getPreferredWidth();
        double most = SHARE * room(table) - 2 * MARGIN;
        boolean fold = longest(table, false) > most;
        int longest = longest(table, fold);
        double smaller = most / longest;
        if (fold)
            smaller = Math.min(smaller, ACROSS * width / getFontMetrics(getFont()).getHeight());
        if (smaller < 1) {
            float size = getFont().getSize2D() * (float) Math.max(SMALLEST, smaller);
            setFont(getFont().deriveFont(size));
            longest = longest(table, fold);
        }
        lines = lines(name, fold);
        setPreferredSize(new Dimension(width, longest + 2 * MARGIN));
        return this;
    }

    private int longest(JTable table, boolean fold) {
        var metrics = getFontMetrics(getFont());
        int longest = metrics.getHeight();
        for (int i = 0; !lying && i < table.getColumnCount(); i++)
            for (String line : lines(table.getColumnName(i), fold))
                longest = Math.max(longest, metrics.stringWidth(line));
        return longest;
    }

    /** The name's lines, folded after the hyphen or at the space that is nearest to the middle. */
    static List<String> lines(String name, boolean fold) {
        int at = 0;
        for (int i = 1; fold && i < name.length() - 1; i++)
            if ("- ".indexOf(name.charAt(i)) >= 0
                    && Math.abs(2 * i + 1 - name.length()) < Math.abs(2 * at + 1 - name.length()))
                at = i;
        return at == 0
                ? List.of(name)
                : List.of(name.substring(0, at + 1).strip(), name.substring(at + 1));
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
            g.drawString(String.join(" ", lines), left, getHeight() - MARGIN);
        } else {
            g.translate((getWidth() + smallLetter(g)) / 2, getHeight() - MARGIN);
            g.rotate(-Math.PI / 2);
            float high = g.getFontMetrics().getHeight();
            float first = -high * (lines.size() - 1) / 2;
            for (int i = 0; i < lines.size(); i++) g.drawString(lines.get(i), 0, first + i * high);
        }
        g.dispose();
    }
}
