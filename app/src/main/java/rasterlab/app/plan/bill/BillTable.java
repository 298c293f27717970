package rasterlab.app.plan.bill;

import com.formdev.flatlaf.ui.FlatEmptyBorder;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.KeyboardFocusManager;
import java.text.NumberFormat;
import java.util.List;
import java.util.Optional;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.border.Border;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import javax.swing.table.TableColumnModel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.plan.CostOrigin;
import rasterlab.engine.plan.Tolerance;

/** The bill of a picture: a row for each stage, and one for all of them. */
public final class BillTable extends JTable {
    private static final long serialVersionUID = 1L;

    private static final List<String> COLUMNS =
            List.of("stage", "counted", "estimated", "milliseconds", "share", "plan");
    private static final int NARROW = 100;
    private static final int LONG = 1_000_000;

    /**
     * The width that the column of stages asks for, more than it gets: it takes what the numbers
     * leave.
     */
    private static final int STAGES = 300;

    private final transient Texts texts;
    private transient Optional<PictureBill> bill = Optional.empty();
    private transient List<PictureBill.BillRow> rows = List.of();

    public BillTable(Language language) {
        texts = Texts.of("plan", language);
        setModel(new Stages());
        setName("bill");
        getAccessibleContext().setAccessibleName(texts.text("table"));
        // Tab leaves the table, whose rows the arrow keys choose.
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setDefaultRenderer(Object.class, new Cells());
        getTableHeader().setReorderingAllowed(false);
        fit();
    }

    /** Gives each column at least the width of its longest cell, so that none is cut. */
    private void fit() {
        for (int column = 0; column < COLUMNS.size(); column++) {
            TableColumn shown = getColumnModel().getColumn(column);
            int least = 0;
            for (int row = 0; row < getRowCount(); row++)
                least =
                        Math.max(
                                least,
                                width(
                                        getCellRenderer(row, column),
                                        getValueAt(row, column),
                                        row,
                                        column));
            TableCellRenderer head = getTableHeader().getDefaultRenderer();
            int named = width(head, shown.getHeaderValue(), -1, column);
            shown.setMinWidth(least);
            shown.setPreferredWidth(column == 0 ? UIScale.scale(STAGES) : Math.max(least, named));
        }
    }

    private int width(TableCellRenderer renderer, Object value, int row, int column) {
        Component drawn =
                renderer.getTableCellRendererComponent(this, value, false, false, row, column);
        return drawn.getPreferredSize().width + getIntercellSpacing().width;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        // The constructor of the table asks for a look before there are columns.
        if (rows != null) fit();
    }

    /** Asks for little width, so that the column beside the stage is not widened. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(NARROW), super.getPreferredSize().height);
    }

    @Override
    protected JTableHeader createDefaultTableHeader() {
        return new NarrowHeader(getColumnModel());
    }

    /** Shows a bill, pale while it is of an earlier picture. */
    public void show(Bills<PictureBill.BilledPicture, PictureBill> bills) {
        setEnabled(bills.current());
        if (!bill.equals(bills.bill())) {
            bill = bills.bill();
            rows = bill.map(PictureBill::rows).orElse(List.of());
            ((AbstractTableModel) getModel()).fireTableDataChanged();
            fit();
            revalidate();
        }
        repaint();
    }

    private String text(int row, int column) {
        return row < rows.size() ? text(rows.get(row), column) : total(column);
    }

    private String text(PictureBill.BillRow row, int column) {
        return switch (column) {
            case 0 -> texts.text("table.stage." + row.stage());
            case 1 -> brief(row.counted());
            case 2 -> brief(row.estimated());
            case 3 -> row.measured().map(this::time).orElse("–");
            case 4 -> row.measured().isPresent() ? percent(row.share()) : "–";
            default -> brief(row.planned());
        };
    }

    private String total(int column) {
        PictureBill all = bill.orElseThrow();
        return switch (column) {
            case 0 -> texts.text("table.all");
            case 3 -> time(all.times().total());
            case 4 -> percent(1);
            case 5 -> texts.text("table.time", time(all.plan().cost().milliseconds()));
            default -> "";
        };
    }

    private String count(Optional<Long> number) {
        return number.map(NumberFormat.getIntegerInstance(texts.locale())::format).orElse("–");
    }

    /** A long count in few digits; its cell's hint has them all. */
    private String brief(Optional<Long> number) {
        if (number.orElse(0L) < LONG) return count(number);
        var format =
                NumberFormat.getCompactNumberInstance(texts.locale(), NumberFormat.Style.SHORT);
        format.setMaximumFractionDigits(2);
        return format.format(number.orElseThrow());
    }

    private String time(double milliseconds) {
        NumberFormat format = NumberFormat.getInstance(texts.locale());
        int decimals = milliseconds < 10 ? 2 : 1;
        format.setMinimumFractionDigits(decimals);
        format.setMaximumFractionDigits(decimals);
        return format.format(milliseconds);
    }

    private String percent(double share) {
        return texts.text("table.percent", Long.toString(Math.round(100 * share)));
    }

    /** Says what a column means; of the first one, the stage's whole name. */
    private String hint(int row, int column) {
        if (column == 0)
            return row < rows.size() ? texts.text("stage." + rows.get(row).stage()) : text(row, 0);
        if (column == 3) return measured(row);
        if (row == rows.size() || column == 4) return meaning(column);
        PictureBill.BillRow stage = rows.get(row);
        Optional<Long> number =
                switch (column) {
                    case 1 -> stage.counted();
                    case 2 -> stage.estimated();
                    default -> stage.planned();
                };
        return count(number) + ": " + meaning(column);
    }

    private String meaning(int column) {
        return texts.text(
                "table." + COLUMNS.get(column) + ".hint",
                COLUMNS.get(column).equals("plan") ? within() : rounds());
    }

    /** How the time of a stage, or of all, was measured, and what its count predicts. */
    private String measured(int row) {
        PictureBill all = bill.orElseThrow();
        double predicted = row < rows.size() ? rows.get(row).predicted() : all.counted().total();
        return texts.text(
                "table.milliseconds.hint",
                rounds(),
                time(predicted),
                CostOrigin.translated(texts, all.counted().origin()));
    }

    private String rounds() {
        return Integer.toString(bill.map(found -> found.times().rounds()).orElse(0));
    }

    private String within() {
        Tolerance within = bill.map(found -> found.plan().tolerance()).orElse(PictureBill.USUAL);
        return texts.text(
                "table.within",
                Shown.number(within.pixels(), texts.locale()),
                Shown.number(within.levels(), texts.locale()));
    }

    /** The columns' names, no wider than the table. */
    private static final class NarrowHeader extends JTableHeader {
        private static final long serialVersionUID = 1L;

        NarrowHeader(TableColumnModel columns) {
            super(columns);
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(UIScale.scale(NARROW), super.getPreferredSize().height);
        }
    }

    private final class Stages extends AbstractTableModel {
        private static final long serialVersionUID = 1L;

        @Override
        public int getRowCount() {
            return bill == null || bill.isEmpty() ? 0 : rows.size() + 1;
        }

        @Override
        public int getColumnCount() {
            return COLUMNS.size();
        }

        @Override
        public String getColumnName(int column) {
            return texts.text("table." + COLUMNS.get(column));
        }

        @Override
        public Object getValueAt(int row, int column) {
            return text(row, column);
        }
    }

    private final class Cells extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;
        private static final Border NARROW_MARGINS = new FlatEmptyBorder(0, 2, 0, 2);

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, on, focused, row, column);
            setHorizontalAlignment(column == 0 ? LEADING : TRAILING);
            setToolTipText(hint(row, column));
            setBorder(NARROW_MARGINS);
            setEnabled(table.isEnabled());
            if (row == rows.size() && column == 0) setFont(getFont().deriveFont(Font.BOLD));
            return this;
        }
    }
}
