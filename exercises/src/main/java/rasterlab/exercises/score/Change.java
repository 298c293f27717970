package rasterlab.exercises.score;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;

/**
 * Changes of lists of numbers and truth values, each the trace of a mistake that is made in any
 * topic. The text on one is {@code change.NAME}.
 */
enum Change {
    NEGATED(numbers(one -> -one)),
    SIGNS_DROPPED(numbers(Math::abs)),
    RECIPROCAL(numbers(one -> 1 / one)),
    TAKEN_FROM_1(numbers(one -> 1 - one)),
    SQUARED(numbers(one -> one * one)),
    ROOT_TAKEN(numbers(Math::sqrt)),
    ROUNDED(numbers(Math::rint)),
    FRACTIONS_CUT_OFF(numbers(one -> one < 0 ? Math.ceil(one) : Math.floor(one))),
    FIRST_NEGATED(columnNegated(0)),
    SECOND_NEGATED(columnNegated(1)),
    THIRD_NEGATED(columnNegated(2)),
    FIRST_AND_SECOND_SWAPPED(columnsSwapped(0, 1)),
    FIRST_AND_THIRD_SWAPPED(columnsSwapped(0, 2)),
    SECOND_AND_THIRD_SWAPPED(columnsSwapped(1, 2)),
    FIRST_FOR_SECOND(columnCopied(0, 1)),
    SECOND_FOR_FIRST(columnCopied(1, 0)),
    REVERSED(rows(Change::reversed)),
    FIRST_LEFT_OUT(rows(rows -> rows.subList(Math.min(1, rows.size()), rows.size()))),
    LAST_LEFT_OUT(rows(rows -> rows.subList(0, Math.max(0, rows.size() - 1)))),
    FIRST_AGAIN_AT_THE_END(rows(Change::closed)),
    EACH_TWICE(rows(Change::twice)),
    ONE_PLACE_LATE(rows(rows -> turned(rows, 1))),
    ONE_PLACE_EARLY(rows(rows -> turned(rows, -1))),
    COLUMN_AFTER_COLUMN(rows(Change::byColumns)),
    TRUE_FOR_FALSE(flags(one -> !one)),
    ALWAYS_TRUE(flags(one -> true));

    private final UnaryOperator<AnswerTable> change;

    Change(UnaryOperator<AnswerTable> change) {
        this.change = change;
    }

    AnswerTable of(AnswerTable right) {
        return change.apply(right);
    }

    /** The name in a text's key. */
    String word() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static UnaryOperator<AnswerTable> numbers(DoubleUnaryOperator change) {
        return table ->
                table.withValues(one -> one instanceof Double a ? change.applyAsDouble(a) : one);
    }

    private static UnaryOperator<AnswerTable> flags(UnaryOperator<Boolean> change) {
        return table -> table.withValues(one -> one instanceof Boolean a ? change.apply(a) : one);
    }

    private static UnaryOperator<AnswerTable> rows(UnaryOperator<List<List<Object>>> change) {
        return table -> table.withRows(change);
    }

    /** Changes each row of so many values or more. */
    private static UnaryOperator<AnswerTable> row(int least, UnaryOperator<List<Object>> change) {
        return rows(
                rows ->
                        rows.stream()
                                .map(row -> row.size() < least ? row : change.apply(row))
                                .toList());
    }

    private static UnaryOperator<AnswerTable> columnNegated(int column) {
        return row(
                Math.max(2, column + 1),
                row -> {
                    List<Object> changed = new ArrayList<>(row);
                    if (row.get(column) instanceof Double a) changed.set(column, -a);
                    return changed;
                });
    }

    private static UnaryOperator<AnswerTable> columnsSwapped(int one, int other) {
        return row(
                Math.max(one, other) + 1,
                row -> {
                    List<Object> changed = new ArrayList<>(row);
                    Collections.swap(changed, one, other);
                    return changed;
                });
    }

    private static UnaryOperator<AnswerTable> columnCopied(int from, int to) {
        return row(
                2,
                row -> {
                    List<Object> changed = new ArrayList<>(row);
                    changed.set(to, row.get(from));
                    return changed;
                });
    }

    private static List<List<Object>> reversed(List<List<Object>> rows) {
        List<List<Object>> reversed = new ArrayList<>(rows);
        Collections.reverse(reversed);
        return reversed;
    }

    private static List<List<Object>> closed(List<List<Object>> rows) {
        List<List<Object>> closed = new ArrayList<>(rows);
        if (!rows.isEmpty()) closed.add(rows.get(0));
        return closed;
    }

    private static List<List<Object>> twice(List<List<Object>> rows) {
        List<List<Object>> twice = new ArrayList<>();
        for (List<Object> row : rows) twice.addAll(List.of(row, row));
        return twice;
    }

    private static List<List<Object>> turned(List<List<Object>> rows, int places) {
        List<List<Object>> turned = new ArrayList<>(rows);
        Collections.rotate(turned, places);
        return turned;
    }

    /** Reads all first values, then all second ones, into rows of the same lengths. */
    private static List<List<Object>> byColumns(List<List<Object>> rows) {
        int columns = rows.isEmpty() ? 0 : rows.get(0).size();
        if (rows.stream().anyMatch(row -> row.size() != columns)) return rows;
        List<Object> all = new ArrayList<>();
        for (int column = 0; column < columns; column++)
            for (List<Object> row : rows) all.add(row.get(column));
        List<List<Object>> changed = new ArrayList<>();
        for (int i = 0; i < rows.size(); i++)
            changed.add(all.subList(i * columns, (i + 1) * columns));
        return changed;
    }
}
