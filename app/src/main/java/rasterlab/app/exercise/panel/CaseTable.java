package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JViewport;
import javax.swing.ListSelectionModel;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.VerdictLook;
import rasterlab.app.language.Texts;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;

/** The cases of a result, one in each row. */
public final class CaseTable extends JTable {
    private static final long serialVersionUID = 1L;

    private static final List<String> COLUMNS = List.of("sign", "case", "points", "verdict");

    /** Left and right of a text, together; more beside large type. */
    private static final int MARGIN = 14;

    private static final Set<GradingVerdict> SHORTEST =
            EnumSet.of(GradingVerdict.OK, GradingVerdict.WRONG);

    /** Verdicts that only a whole submission has. */
    public static final Set<GradingVerdict> OF_NO_CASE =
            EnumSet.of(
                    GradingVerdict.COMPILE_ERROR, GradingVerdict.REFUSED, GradingVerdict.INTERNAL);

    private final transient Texts texts;
    private final transient Rows rows = new Rows();
    private transient UnaryOperator<String> titles = UnaryOperator.identity();
    private final TableColumn verdict;

    /**
     * @param chosen run when another case is chosen
     */
    public CaseTable(Texts texts, Runnable chosen) {
        this.texts = texts;
        setModel(rows);
        setName("cases");
        getAccessibleContext().setAccessibleName(texts.text("cases"));
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setShowVerticalLines(false);
        setFillsViewportHeight(true);
        getTableHeader().setReorderingAllowed(false);
        if (getTableHeader().getDefaultRenderer() instanceof JLabel head)
            head.setHorizontalAlignment(JLabel.LEADING);
        setFont(getFont());
        verdict = getColumnModel().getColumn(3);
        getSelectionModel()
                .addListSelectionListener(
                        e -> {
                            if (!e.getValueIsAdjusting()) chosen.run();
                        });
    }

    /** Rows and head go with the type. */
    @Override
    public void setFont(Font type) {
        super.setFont(type);
        if (type != null) setRowHeight(getFontMetrics(type).getHeight() + 6);
        if (getTableHeader() != null) getTableHeader().setFont(type);
    }

    /**
     * Lays the columns out, without verdicts in words where they would be cut off: signs tell them
     * too.
     */
    @Override
    public void doLayout() {
        int rest = getWidth() - least();
        boolean roomy = rest >= Math.max(verdictWidth(SHORTEST), widest(3));
        if (roomy && getColumnCount() < COLUMNS.size()) addColumn(verdict);
        if (!roomy && getColumnCount() == COLUMNS.size()) removeColumn(verdict);
        width(0, widest(0));
        width(2, widest(2));
        if (roomy) width(3, widest(3));
        super.doLayout();
    }

    /** The width in which no verdict of a case is cut off, so that no place moves by it. */
    int needed() {
        return least() + verdictWidth(EnumSet.complementOf(EnumSet.copyOf(OF_NO_CASE)));
    }

    /** The width of all columns but that of verdicts. */
    int least() {
        return IntStream.range(0, COLUMNS.size() - 1).map(this::widest).sum();
    }

    private int verdictWidth(Set<GradingVerdict> verdicts) {
        var metrics = getFontMetrics(getFont());
        return margin()
                + verdicts.stream()
                        .map(one -> inWords(one.code()))
                        .mapToInt(metrics::stringWidth)
                        .max()
                        .orElseThrow();
    }

    private String inWords(String verdict) {
        return verdict.isEmpty() ? "–" : GradingVerdict.word(verdict, texts.locale().getLanguage());
    }

    /** Width of a column with its head. */
    private int widest(int column) {
        var metrics = getFontMetrics(getFont());
        int widest = metrics.stringWidth(column == 0 ? "✓" : head(column));
        for (int row = 0; row < rows.getRowCount(); row++)
            widest = Math.max(widest, metrics.stringWidth(longest(row, column)));
        return widest + margin();
    }

    /** The text of a cell, now or once its case is tried. */
    private String longest(int row, int column) {
        int of = rows.cases.get(row).of();
        return column == 2 ? of + "/" + of : String.valueOf(rows.getValueAt(row, column));
    }

    private static int margin() {
        return Math.max(MARGIN, UIScale.scale(MARGIN - 3));
    }

    private void width(int column, int width) {
        var shape = getColumnModel().getColumn(column);
        // A least width is cut to the greatest one, and a greatest raised to the least.
        shape.setMinWidth(0);
        shape.setMaxWidth(width);
        shape.setMinWidth(width);
    }

    private String head(int column) {
        return column == 0 ? "" : texts.text("column." + COLUMNS.get(column));
    }

    /**
     * Shows other cases; the chosen one stays chosen if there is one of its name.
     *
     * @param named a case's name to what it is called in the table's language
     */
    public void show(List<CaseResult> cases, UnaryOperator<String> named) {
        titles = named;
        if (cases.equals(rows.cases)) return;
        String chosen = chosen().map(CaseResult::name).orElse("");
        rows.cases = List.copyOf(cases);
        rows.fireTableDataChanged();
        choose(chosen);
    }

    /** Chooses the case of that name and has it in sight; one that is not there leaves none. */
    public void choose(String name) {
        for (int i = 0; i < rows.cases.size(); i++)
            if (rows.cases.get(i).name().equals(name)) {
                setRowSelectionInterval(i, i);
                scrollRectToVisible(getCellRect(i, 0, true));
            }
    }

    /** Chooses the first case where none is chosen. */
    void chooseAny() {
        if (getSelectedRow() < 0 && getRowCount() > 0) setRowSelectionInterval(0, 0);
    }

    /** The table in what scrolls it, where the chosen case is in sight in each of its sizes. */
    JScrollPane scrolled() {
        var scroll = new JScrollPane(this);
        JViewport viewport = scroll.getViewport();
        var before = new AtomicReference<>(viewport.getExtentSize());
        viewport.addChangeListener(
                e -> {
                    Dimension size = viewport.getExtentSize();
                    if (!size.equals(before.getAndSet(size))) scrollToChosen();
                });
        return scroll;
    }

    /** Has the chosen case in sight, and as many of the first ones as can be beside it. */
    void scrollToChosen() {
        scrollRectToVisible(getCellRect(0, 0, true));
        if (getSelectedRow() >= 0) scrollRectToVisible(getCellRect(getSelectedRow(), 0, true));
    }

    Optional<CaseResult> chosen() {
        int row = getSelectedRow();
        return row < 0 || row >= rows.cases.size()
                ? Optional.empty()
                : Optional.of(rows.cases.get(row));
    }

    @Override
    public TableCellRenderer getCellRenderer(int row, int column) {
        return new Cell(rows.cases.get(row));
    }

    private final class Cell extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        private final transient CaseResult shown;

        Cell(CaseResult shown) {
            this.shown = shown;
        }

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, on, focused, row, column);
            boolean colored =
                    !on && VerdictLook.tried(shown.verdict()) && column != 1 && column != 2;
            if (colored) setForeground(VerdictLook.color(shown.verdict(), getBackground()));
            else if (!on) setForeground(table.getForeground());
            String said = shown.message().in(texts.language());
            setToolTipText(said.isEmpty() ? titleAndName() : said);
            setHorizontalAlignment(column == 0 || column == 2 ? CENTER : LEADING);
            return this;
        }

        private String titleAndName() {
            String title = titles.apply(shown.name());
            return title.equals(shown.name()) ? title : title + " (" + shown.name() + ")";
        }
    }

    private final class Rows extends AbstractTableModel {
        private static final long serialVersionUID = 1L;

        private transient List<CaseResult> cases = List.of();

        @Override
        public int getRowCount() {
            return cases.size();
        }

        @Override
        public int getColumnCount() {
            return COLUMNS.size();
        }

        @Override
        public String getColumnName(int column) {
            return head(column);
        }

        @Override
        public Object getValueAt(int row, int column) {
            CaseResult one = cases.get(row);
            return switch (column) {
                case 0 -> VerdictLook.sign(one.verdict());
                case 1 -> titles.apply(one.name());
                case 2 ->
                        one.verdict().isEmpty()
                                ? one.of()
                                : CaseReport.pointsOf(one.points(), one.of());
                default -> inWords(one.verdict());
            };
        }
    }
}
