package rasterlab.app.study;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.method.SecondaryText;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/**
 * The method × hazard table: what is written down in pale, what was found just now in colour, and
 * an exclamation mark where the two differ.
 */
final class HazardTable extends JTable {
    private static final long serialVersionUID = 1L;

    /** Width of a method's column in view units; more where large signs need it. */
    private static final int COLUMN = 46;

    /** How many times as wide columns get where there is room. */
    private static final int WIDEST = 3;

    /** How many times as high rows get likewise, and by what part of that their signs grow. */
    private static final int HIGHEST = 2;

    private static final float SIGN = 0.5f;

    private final transient StudyLabModel model;
    private final transient Texts texts;
    private final transient TopicNames called;
    private final transient Cells cells = new Cells();
    private final HazardNames names;
    private transient Topic<?, ?, ?> shown;
    private transient List<? extends Hazard<?>> hazards = List.of();
    private transient List<? extends Method<?>> methods = List.of();
    private boolean refreshing;
    private final int leastRow = getFontMetrics(getFont()).getHeight() + 8;
    private Dimension room = new Dimension();

    /**
     * @param open brings the chosen cell's scene to its tab
     */
    HazardTable(StudyLabModel model, Texts texts, Runnable open) {
        this.model = model;
        this.texts = texts;
        called = TopicNames.in(texts.language());
        setName("hazards");
        getAccessibleContext().setAccessibleName(texts.text("hazards"));
        // Tab leaves the table, whose cells the arrow keys choose.
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        setAutoResizeMode(AUTO_RESIZE_OFF);
        setCellSelectionEnabled(true);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setFillsViewportHeight(true);
        getTableHeader().setReorderingAllowed(false);
        getTableHeader().setResizingAllowed(false);
        setRowHeight(leastRow);
        getSelectionModel().addListSelectionListener(e -> choose());
        getColumnModel().getSelectionModel().addListSelectionListener(e -> choose());
        names = new HazardNames(this, texts.text("hazard"));
        KeyBinding.whenFocused(this, KeyStroke.getKeyStroke("ENTER"), open);
        addMouseListener(
                new MouseAdapter() {
                    @Override
                    public void mouseClicked(MouseEvent e) {
                        if (e.getClickCount() == 2) open.run();
                    }
                });
    }

    /** The table with the names of its rows beside it, which stay while the methods scroll. */
    JScrollPane scroll() {
        var scroll = new JScrollPane(this);
        scroll.setName("hazards.scroll");
        scroll.setRowHeaderView(names);
        scroll.setCorner(ScrollPaneConstants.UPPER_LEFT_CORNER, names.getTableHeader());
        scroll.getViewport().addChangeListener(e -> spread(scroll.getViewport().getSize()));
        return scroll;
    }

    /** The whole table with its names, as an SVG document. */
    SvgDrawing svg() {
        Dimension whole = whole();
        return SvgPicture.of(whole.width, whole.height, this::printWhole);
    }

    /** The table dot by dot. */
    BufferedImage dots() {
        Dimension whole = whole();
        return DevicePixels.painted(
                whole.width, whole.height, DevicePixels.scale(this), this::printWhole);
    }

    private Dimension whole() {
        return new Dimension(
                names.getPreferredSize().width + getPreferredSize().width,
                getTableHeader().getPreferredSize().height + getRowCount() * getRowHeight());
    }

    private void printWhole(Graphics2D g) {
        int left = names.getPreferredSize().width;
        int top = getTableHeader().getPreferredSize().height;
        Dimension whole = whole();
        int right = whole.width - left;
        int rows = whole.height - top;
        print(names.getTableHeader(), new Rectangle(0, 0, left, top), g);
        print(getTableHeader(), new Rectangle(left, 0, right, top), g);
        print(names, new Rectangle(0, top, left, rows), g);
        print(this, new Rectangle(left, top, right, rows), g);
    }

    private static void print(JComponent part, Rectangle place, Graphics2D g) {
        shape(part, place.width, place.height);
        SvgPicture.within(place, g, part::print);
    }

    /** A part that no window has laid out yet. */
    private static void shape(JComponent part, int width, int height) {
        if (part.getWidth() > 0) return;
        part.setSize(width, height);
        part.doLayout();
    }

    private void choose() {
        int row = getSelectedRow();
        int column = getSelectedColumn();
        if (refreshing || row < 0 || column < 0 || column >= methods.size()) return;
        model.choose(hazards.get(row).name(), methods.get(column).name());
    }

    void refresh() {
        refreshing = true;
        if (shown != model.state().topic()) {
            shown = model.state().topic();
            // A topic makes its lists anew with every call, too slow for each cell.
            hazards = shown.hazards();
            methods = shown.methods();
            setModel(cells);
            cells.fireTableStructureChanged();
            shape();
        }
        repaint();
        refreshing = false;
    }

    private void shape() {
        for (int i = 0; i < getColumnCount(); i++)
            getColumnModel().getColumn(i).setHeaderRenderer(new UprightHeader(false));
        fill();
        names.show(shown, hazards, called);
    }

    private void spread(Dimension size) {
        if (size.equals(room)) return;
        room = size;
        fill();
    }

    /** Shares the room out among the methods and among the hazards. */
    private void fill() {
        int width =
                share(
                        room.width,
                        getColumnCount(),
                        Math.max(COLUMN, 2 * getFont().getSize()),
                        WIDEST);
        for (int i = 0; i < getColumnCount(); i++) width(i, width);
        int height = share(room.height, getRowCount(), leastRow, HIGHEST);
        if (height == getRowHeight()) return;
        setRowHeight(height);
        names.setRowHeight(height);
    }

    private static int share(int room, int count, int least, int most) {
        return Math.max(least, Math.min(most * least, room / Math.max(1, count)));
    }

    private void width(int column, int width) {
        var shape = getColumnModel().getColumn(column);
        shape.setMinWidth(width);
        shape.setMaxWidth(width);
        shape.setPreferredWidth(width);
    }

    private Verdict.Kind recorded(int row, int column) {
        var hazard = hazards.get(row);
        return hazard.recorded().getOrDefault(methods.get(column).name(), Verdict.Kind.EXACT);
    }

    /** Whether the column is that of the user's program, of which nothing is written down. */
    private boolean isOwn(int column) {
        return methods.get(column).name().equals(OwnMethods.NAME);
    }

    private Optional<VerdictCell> fresh(int row, int column) {
        return model.state().cell(hazards.get(row).name(), methods.get(column).name());
    }

    @Override
    public TableCellRenderer getCellRenderer(int row, int column) {
        return new VerdictRenderer();
    }

    private final class VerdictRenderer extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, on, focused, row, column);
            Optional<VerdictCell> fresh = fresh(row, column);
            Verdict.Kind kind =
                    fresh.map(cell -> cell.verdict().kind()).orElse(recorded(row, column));
            setHorizontalAlignment(CENTER);
            if (!on)
                setForeground(
                        fresh.isPresent()
                                ? VerdictSign.of(kind).ink(getBackground())
                                : SecondaryText.on(getBackground()));
            float larger = 1 + SIGN * (getRowHeight() - leastRow) / leastRow;
            setFont(
                    getFont()
                            .deriveFont(
                                    fresh.isPresent() ? Font.BOLD : Font.PLAIN,
                                    larger * getFont().getSize2D()));
            setToolTipText(
                    texts.text(
                            fresh.isPresent()
                                    ? "cell.fresh"
                                    : isOwn(column) ? "cell.untried" : "cell.recorded",
                            OwnWords.called(methods.get(column).name(), texts.language()),
                            called.hazard(shown, hazards.get(row)),
                            texts.text("verdict." + kind.code())));
            return this;
        }
    }

    private final class Cells extends AbstractTableModel {
        private static final long serialVersionUID = 1L;

        @Override
        public int getRowCount() {
            return hazards.size();
        }

        @Override
        public int getColumnCount() {
            return methods.size();
        }

        @Override
        public String getColumnName(int column) {
            return OwnWords.called(methods.get(column).name(), texts.language());
        }

        @Override
        public Object getValueAt(int row, int column) {
            Optional<VerdictCell> fresh = fresh(row, column);
            if (fresh.isEmpty())
                return isOwn(column) ? "" : VerdictSign.of(recorded(row, column)).sign();
            String sign = VerdictSign.of(fresh.get().verdict().kind()).sign();
            return isOwn(column) || fresh.get().asRecorded() ? sign : sign + " !";
        }
    }
}
