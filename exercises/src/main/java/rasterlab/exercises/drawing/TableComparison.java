package rasterlab.exercises.drawing;

import java.util.Optional;

/**
 * Two tables held against each other, cell by cell. A cell that one of them lacks is missing or
 * extra.
 */
final class TableComparison {
    /** How a cell of the actual table stands to the expected one. */
    enum CellState {
        /** The cell that neither table has. */
        ABSENT,
        RIGHT,
        WRONG,
        MISSING,
        EXTRA;

        boolean isWrong() {
            return this == WRONG || this == MISSING || this == EXTRA;
        }
    }

    /** A place in both tables, from 0. */
    record TableCell(int row, int column) {}

    private final double[][] expected;
    private final double[][] actual;
    private final Agreement agreement;

    TableComparison(double[][] expected, double[][] actual, Agreement agreement) {
        this.expected = expected;
        this.actual = actual;
        this.agreement = agreement;
    }

    /** Rows of the longer table. */
    int rows() {
        return Math.max(expected.length, actual.length);
    }

    /** Cells of the longest row. */
    int columns() {
        int most = 0;
        for (double[] row : expected) most = Math.max(most, row.length);
        for (double[] row : actual) most = Math.max(most, row.length);
        return most;
    }

    CellState state(int row, int column) {
        boolean wanted = has(expected, row, column);
        if (!has(actual, row, column)) return wanted ? CellState.MISSING : CellState.ABSENT;
        if (!wanted) return CellState.EXTRA;
        return agreement.holds(row, column, expected[row][column], actual[row][column])
                ? CellState.RIGHT
                : CellState.WRONG;
    }

    /** The first cell, row by row, that is wrong, missing or extra. */
    Optional<TableCell> firstWrong() {
        int columns = columns();
        for (int row = 0; row < rows(); row++)
            for (int column = 0; column < columns; column++)
                if (state(row, column).isWrong()) return Optional.of(new TableCell(row, column));
        return Optional.empty();
    }

    /** Number of cells in that state. */
    int count(CellState state) {
        int columns = columns();
        int count = 0;
        for (int row = 0; row < rows(); row++)
            for (int column = 0; column < columns; column++)
                if (state(row, column) == state) count++;
        return count;
    }

    /** The expected number; empty where that table has no such cell. */
    String expected(int row, int column) {
        return has(expected, row, column) ? written(expected, row, column) : "";
    }

    /** The actual number; empty where that table has no such cell. */
    String actual(int row, int column) {
        return has(actual, row, column) ? written(actual, row, column) : "";
    }

    /** The number actual − expected, 0 where the two agree without one; empty for a lone cell. */
    String difference(int row, int column) {
        if (!has(expected, row, column) || !has(actual, row, column)) return "";
        double wanted = expected[row][column];
        double got = actual[row][column];
        boolean same = Double.compare(wanted, got) == 0;
        return NumberText.of(same ? 0 : got - wanted + 0.0);
    }

    private String written(double[][] table, int row, int column) {
        int digits =
                state(row, column) == CellState.WRONG
                        ? NumberText.telling(expected[row][column], actual[row][column])
                        : NumberText.USUAL_DIGITS;
        return NumberText.of(table[row][column], digits);
    }

    private static boolean has(double[][] table, int row, int column) {
        return row < table.length && column < table[row].length;
    }
}
