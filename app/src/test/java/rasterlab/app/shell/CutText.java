package rasterlab.app.shell;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableColumn;
import javax.swing.text.BadLocationException;

/** Whether a laid out component shows all of its own text, and how much is lacking. */
final class CutText {
    /** Sizes that MigLayout rounds one by one are larger than their rounded sum by so much. */
    private static final int ROUNDING = 4;

    private CutText() {}

    static Optional<String> of(Component component) {
        if (component instanceof JSpinner spinner) return inField(spinner);
        if (component instanceof JTableHeader header) return inHeads(header.getTable());
        boolean text =
                component instanceof JLabel
                        || component instanceof AbstractButton
                        || component instanceof JComboBox;
        boolean slider = component instanceof JSlider;
        // A scroll bar's buttons are hidden by having no size; they have no name either.
        if (!slider && !(text && component.getName() != null)) return Optional.empty();
        int needed = slider ? component.getMinimumSize().width : component.getPreferredSize().width;
        if (component.getWidth() < needed)
            return lacking(component, "", needed, component.getWidth());
        return outside(component);
    }

    /** Wide enough itself, but beyond the edge of what holds it. */
    private static Optional<String> outside(Component component) {
        if (component.getParent() instanceof JViewport) return Optional.empty();
        int end = component.getX() + component.getWidth();
        int room = component.getParent().getWidth();
        return end <= room + ROUNDING ? Optional.empty() : lacking(component, "", end, room);
    }

    private static Optional<String> inField(JSpinner spinner) {
        JTextField field = ((JSpinner.DefaultEditor) spinner.getEditor()).getTextField();
        int needed = field.getFontMetrics(field.getFont()).stringWidth(field.getText());
        int room = room(field);
        return room >= needed ? Optional.empty() : lacking(spinner, field.getText(), needed, room);
    }

    /** Width in which text is seen: what insets, padding and caret leave. */
    private static int room(JTextField field) {
        try {
            field.modelToView2D(0); // Brings the visible part up to date.
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
        return field.getHorizontalVisibility().getExtent();
    }

    private static Optional<String> inHeads(JTable table) {
        List<String> cut = new ArrayList<>();
        for (int i = 0; i < table.getColumnCount(); i++) {
            TableColumn column = table.getColumnModel().getColumn(i);
            var renderer = column.getHeaderRenderer();
            if (renderer == null) renderer = table.getTableHeader().getDefaultRenderer();
            Object head = column.getHeaderValue();
            int needed =
                    renderer.getTableCellRendererComponent(table, head, false, false, -1, i)
                            .getPreferredSize()
                            .width;
            if (column.getWidth() < needed)
                lacking(table, String.valueOf(head), needed, column.getWidth()).ifPresent(cut::add);
        }
        return cut.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", cut));
    }

    private static Optional<String> lacking(
            Component component, String text, int needed, int width) {
        return Optional.of(
                "%s %s %s: needs %d, has %d"
                        .formatted(
                                component.getClass().getSimpleName(),
                                component.getName(),
                                text,
                                needed,
                                width));
    }
}
