package rasterlab.app.visibility;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.engine.visibility.buffer.PixelTouch;

/** The history of a pixel: a row for each face that touched it. */
final class TouchTable extends JTable {
    private static final long serialVersionUID = 1L;

    private static final String[] COLUMNS = {"step", "face", "z", "verdict", "colours"};
    private static final int[] WIDTHS = {40, 44, 62, 112, 50};

    private final transient Texts texts;
    private transient List<PixelTouch> touches = List.of();

    TouchTable(Texts texts) {
        this.texts = texts;
        setModel(new Touches());
        setName("history");
        getAccessibleContext().setAccessibleName(texts.text("history"));
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setDefaultRenderer(Object.class, new Cells());
        getTableHeader().setReorderingAllowed(false);
        for (int i = 0; i < WIDTHS.length; i++)
            getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(WIDTHS[i]));
    }

    void show(List<PixelTouch> found) {
        if (found.equals(touches)) return;
        touches = found;
        ((AbstractTableModel) getModel()).fireTableDataChanged();
    }

    private String text(PixelTouch touch, int column) {
        return switch (column) {
            case 0 -> touch.step() == 0 ? "–" : Integer.toString(touch.step());
            case 1 -> Integer.toString(touch.face());
            case 2 -> Shown.number(touch.z(), 2, texts.locale());
            case 3 -> texts.text("verdict." + touch.verdict().name().toLowerCase(Locale.ROOT));
            default -> "";
        };
    }

    /** The compared depths in words, or what the verdict means. */
    private String hint(PixelTouch touch) {
        String verdict = touch.verdict().name().toLowerCase(Locale.ROOT);
        if (touch.test().isEmpty()) return texts.text("verdict." + verdict + ".hint");
        OptionalDouble held = touch.test().get().held();
        String other =
                held.isPresent()
                        ? Shown.number(held.getAsDouble(), 7, texts.locale())
                        : texts.text("test.empty");
        String own = Shown.number(touch.test().get().offered(), 7, texts.locale());
        return texts.text("test", own, other);
    }

    private final class Touches extends AbstractTableModel {
        private static final long serialVersionUID = 1L;

        @Override
        public int getRowCount() {
            return touches == null ? 0 : touches.size();
        }

        @Override
        public int getColumnCount() {
            return COLUMNS.length;
        }

        @Override
        public String getColumnName(int column) {
            return texts.text("history." + COLUMNS[column]);
        }

        @Override
        public Object getValueAt(int row, int column) {
            return text(touches.get(row), column);
        }
    }

    private final class Cells extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, on, focused, row, column);
            PixelTouch touch = touches.get(row);
            boolean text = column == 3;
            setHorizontalAlignment(text ? LEADING : TRAILING);
            setToolTipText(hint(touch));
            setIcon(column == 4 ? new ColorPair(touch.before(), touch.after()) : null);
            return this;
        }
    }

    /** The pixel's colour before and after. */
    private record ColorPair(int before, int after) implements Icon {
        @Override
        public void paintIcon(Component c, Graphics g, int x, int y) {
            int side = getIconHeight();
            square(g, before, x, y, side);
            square(g, after, x + side + side / 2, y, side);
            g.setColor(c.getForeground());
            int middle = y + side / 2;
            g.drawLine(x + side + 1, middle, x + side + side / 2 - 2, middle);
        }

        private static void square(Graphics g, int argb, int x, int y, int side) {
            g.setColor(new Color(argb));
            g.fillRect(x, y, side, side);
            g.setColor(Color.GRAY);
            g.drawRect(x, y, side - 1, side - 1);
        }

        @Override
        public int getIconWidth() {
            return getIconHeight() * 5 / 2;
        }

        @Override
        public int getIconHeight() {
            return UIScale.scale(13);
        }
    }
}
