package rasterlab.app.study;

import java.awt.Dimension;
import java.util.List;
import javax.swing.JTable;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

/** The names of hazards, which stay beside the table of verdicts while its methods scroll. */
final class HazardNames extends JTable {
    private static final long serialVersionUID = 1L;

    private static final int MARGIN = 20;

    private final transient Names names;

    /**
     * @param beside its rows are these names' rows, its chosen row is theirs
     * @param heading over the names
     */
    HazardNames(HazardTable beside, String heading) {
        names = new Names(heading);
        setName("hazards.names");
        getAccessibleContext().setAccessibleName(heading);
        setModel(names);
        setSelectionModel(beside.getSelectionModel());
        setFont(beside.getFont());
        setRowHeight(beside.getRowHeight());
        setFocusable(false);
        setFillsViewportHeight(true);
        getTableHeader().setReorderingAllowed(false);
        getTableHeader().setResizingAllowed(false);
        getTableHeader().setDefaultRenderer(new UprightHeader(true));
        setDefaultRenderer(Object.class, new Cell());
    }

    void show(Topic<?, ?, ?> topic, List<? extends Hazard<?>> hazards, TopicNames called) {
        names.shown = hazards.stream().map(each -> called.hazard(topic, each)).toList();
        names.fireTableDataChanged();
        var metrics = getFontMetrics(getFont());
        int width =
                MARGIN
                        + names.shown.stream()
                                .mapToInt(metrics::stringWidth)
                                .reduce(metrics.stringWidth(names.heading), Math::max);
        getColumnModel().getColumn(0).setPreferredWidth(width);
        setPreferredScrollableViewportSize(new Dimension(width, 0));
    }

    private final class Cell extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public java.awt.Component getTableCellRendererComponent(
                JTable table, Object value, boolean on, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, on, false, row, column);
            setToolTipText(names.shown.get(row));
            return this;
        }
    }

    private static final class Names extends AbstractTableModel {
        private static final long serialVersionUID = 1L;

        private final String heading;
        private transient List<String> shown = List.of();

        Names(String heading) {
            this.heading = heading;
        }

        @Override
        public int getRowCount() {
            return shown.size();
        }

        @Override
        public int getColumnCount() {
            return 1;
        }

        @Override
        public String getColumnName(int column) {
            return heading;
        }

        @Override
        public Object getValueAt(int row, int column) {
            return shown.get(row);
        }
    }
}
