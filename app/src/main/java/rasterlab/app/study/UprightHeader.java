package rasterlab.app.study;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.UIManager;
import javax.swing.table.TableCellRenderer;

/** Names of columns that stand upright, so that a column is as narrow as its sign. */
final class UprightHeader extends JComponent implements TableCellRenderer {
    private static final long serialVersionUID = 1L;

    private static final int MARGIN = 8;

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
        int longest = getFontMetrics(getFont()).getHeight();
        for (int i = 0; !lying && i < table.getColumnCount(); i++)
            longest =
                    Math.max(
                            longest, getFontMetrics(getFont()).stringWidth(table.getColumnName(i)));
        int width = table.getColumnModel().getColumn(column).getPreferredWidth();
        setPreferredSize(new Dimension(width, longest + 2 * MARGIN));
        return this;
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
        var metrics = g.getFontMetrics();
        if (lying) {
            g.drawString(name, MARGIN - 2, getHeight() - MARGIN);
        } else {
            g.translate((getWidth() + metrics.getAscent()) / 2 - 1, getHeight() - MARGIN);
            g.rotate(-Math.PI / 2);
            g.drawString(name, 0, 0);
        }
        g.dispose();
    }
}
