package rasterlab.app.study;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.Cell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/**
 * The method × hazard table: what is written down in pale, what was found just now in colour, and
 * an exclamation mark where the two differ.
 */
final class HazardTable extends JTable {
    private static final long serialVersionUID = 1L;

    private static final int COLUMN = 46;

    private final transient StudyLabModel model;
    private final transient Texts texts;
    private final transient Cells cells = new Cells();
    private transient Topic<?, ?, ?> shown;
    private boolean refreshing;

    /**
     * @param open brings the chosen cell's scene to its tab
     */
    HazardTable(StudyLabModel model, Texts texts, Runnable open) {
        this.model = model;
        this.texts = texts;
        setName("hazards");
        getAccessibleContext().setAccessibleName(texts.text("hazards"));
        setAutoResizeMode(AUTO_RESIZE_OFF);
        setCellSelectionEnabled(true);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setFillsViewportHeight(true);
        getTableHeader().setReorderingAllowed(false);
        getTableHeader().setResizingAllowed(false);
        setRowHeight(getFontMetrics(getFont()).getHeight() + 8);
        getSelectionModel().addListSelectionListener(e -> choose());
        getColumnModel().getSelectionModel().addListSelectionListener(e -> choose());
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke("ENTER"), open);
        addMouseListener(
                new MouseAdapter() {
                    @Override
                    public void mouseClicked(MouseEvent e) {
                        if (e.getClickCount() == 2) open.run();
                    }
                });
    }

    private void choose() {
        int row = getSelectedRow();
        int column = getSelectedColumn();
        if (refreshing || row < 0 || column < 1 || column > methods().size()) return;
        model.choose(hazards().get(row).name(), methods().get(column - 1).name());
    }

    private List<? extends Hazard<?>> hazards() {
        return model.state().topic().hazards();
    }

    private List<? extends Method<?>> methods() {
        return model.state().topic().methods();
    }

    void refresh() {
        refreshing = true;
        if (shown != model.state().topic()) {
            shown = model.state().topic();
            setModel(cells);
            cells.fireTableStructureChanged();
            shape();
        }
        repaint();
        refreshing = false;
    }

    private void shape() {
        var metrics = getFontMetrics(getFont());
        int first =
                hazards().stream()
                        .mapToInt(hazard -> metrics.stringWidth(hazard.name()))
                        .max()
                        .orElse(0);
        width(0, first + 20);
        for (int i = 1; i < getColumnCount(); i++) width(i, COLUMN);
        for (int i = 0; i < getColumnCount(); i++)
            getColumnModel().getColumn(i).setHeaderRenderer(new Upright());
    }

    private void width(int column, int width) {
        var shape = getColumnModel().getColumn(column);
        shape.setMinWidth(width);
        shape.setMaxWidth(width);
        shape.setPreferredWidth(width);
    }

    private Verdict.Kind recorded(int row, int column) {
        var hazard = hazards().get(row);
        return hazard.recorded().getOrDefault(methods().get(column - 1).name(), Verdict.Kind.EXACT);
    }

    private Optional<Cell> fresh(int row, int column) {
        return model.state().cell(hazards().get(row).name(), methods().get(column - 1).name());
    }

    @Override
    public TableCellRenderer getCellRenderer(int row, int column) {
        return column == 0 ? super.getCellRenderer(row, column) : new VerdictCell();
    }

    private final class VerdictCell extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, on, focused, row, column);
            Optional<Cell> fresh = fresh(row, column);
            Verdict.Kind kind =
                    fresh.map(cell -> cell.verdict().kind()).orElse(recorded(row, column));
            setHorizontalAlignment(CENTER);
            if (!on) setForeground(fresh.isPresent() ? VerdictSign.of(kind).ink() : pale());
            if (fresh.isPresent()) setFont(getFont().deriveFont(Font.BOLD));
            setToolTipText(
                    texts.text(
                            fresh.isPresent() ? "cell.fresh" : "cell.recorded",
                            methods().get(column - 1).name(),
                            hazards().get(row).name(),
                            texts.text("verdict." + kind.code())));
            return this;
        }
    }

    private static Color pale() {
        return UIManager.getColor("Label.disabledForeground");
    }

    private final class Cells extends AbstractTableModel {
        private static final long serialVersionUID = 1L;

        @Override
        public int getRowCount() {
            return hazards().size();
        }

        @Override
        public int getColumnCount() {
            return methods().size() + 1;
        }

        @Override
        public String getColumnName(int column) {
            return column == 0 ? texts.text("hazard") : methods().get(column - 1).name();
        }

        @Override
        public Object getValueAt(int row, int column) {
            if (column == 0) return hazards().get(row).name();
            Optional<Cell> fresh = fresh(row, column);
            if (fresh.isEmpty()) return VerdictSign.of(recorded(row, column)).sign();
            String sign = VerdictSign.of(fresh.get().verdict().kind()).sign();
            return fresh.get().asRecorded() ? sign : sign + " !";
        }
    }

    /** Names of methods that stand upright, so that a column is as narrow as its sign. */
    private static final class Upright extends JComponent implements TableCellRenderer {
        private static final long serialVersionUID = 1L;

        private String name = "";
        private boolean lying;

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            name = String.valueOf(value);
            lying = column == 0;
            setFont(table.getFont());
            int longest = 0;
            for (int i = 1; i < table.getColumnCount(); i++)
                longest =
                        Math.max(
                                longest,
                                getFontMetrics(getFont()).stringWidth(table.getColumnName(i)));
            setPreferredSize(new Dimension(COLUMN, longest + 16));
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
                g.drawString(name, 6, getHeight() - 8);
            } else {
                g.translate((getWidth() + metrics.getAscent()) / 2 - 1, getHeight() - 8);
                g.rotate(-Math.PI / 2);
                g.drawString(name, 0, 0);
            }
            g.dispose();
        }
    }
}
