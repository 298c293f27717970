package rasterlab.exercises.drawing;

import java.util.List;

/**
 * The names of a table's rows and columns: signs rather than words, such as {@code x} or {@code R}.
 * Rows and columns beyond the lists are called by their number, from 0.
 *
 * @param rows names from the first row on
 * @param columns names from the first column on
 */
public record TableLabels(List<String> rows, List<String> columns) {
    /** Labels that number rows and columns from 0. */
    public static final TableLabels NUMBERS = new TableLabels(List.of(), List.of());

    public TableLabels {
        rows = List.copyOf(rows);
        columns = List.copyOf(columns);
    }

    String row(int index) {
        return label(rows, index);
    }

    String column(int index) {
        return label(columns, index);
    }

    private static String label(List<String> labels, int index) {
        return index < labels.size() ? labels.get(index) : String.valueOf(index);
    }
}
