package rasterlab.exercises.score;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.DoublePredicate;
import java.util.function.UnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * The lists of an answer as rows: a point, a triangle or another list of values is a row, and so is
 * each value of a list that is in no other. What is no list is left out.
 *
 * @param fields rows by the name of their field; a value is a number, a truth value or a text
 */
record AnswerTable(Map<String, List<List<Object>>> fields) {
    /** The part of the largest number by which two that are the same may differ. */
    private static final double ROUNDING = 1e-9;

    static AnswerTable of(JsonNode answer) {
        Map<String, List<List<Object>>> fields = new LinkedHashMap<>();
        answer.properties()
                .forEach(
                        field -> {
                            if (!field.getValue().isArray()) return;
                            List<List<Object>> rows = new ArrayList<>();
                            addRows(field.getValue(), rows, true);
                            fields.put(field.getKey(), rows);
                        });
        return new AnswerTable(fields);
    }

    private static void addRows(JsonNode list, List<List<Object>> rows, boolean outermost) {
        List<Object> row = new ArrayList<>();
        for (JsonNode one : list) {
            if (one.isArray()) addRows(one, rows, false);
            else if (outermost) rows.add(List.of(value(one)));
            else row.add(value(one));
        }
        if (!row.isEmpty()) rows.add(row);
    }

    /** A number that has no place in JSON stands by its name. */
    private static Object value(JsonNode one) {
        if (one.isNumber()) return one.doubleValue();
        if (one.isBoolean()) return one.booleanValue();
        return switch (one.asText()) {
            case "NaN" -> Double.NaN;
            case "Infinity" -> Double.POSITIVE_INFINITY;
            case "-Infinity" -> Double.NEGATIVE_INFINITY;
            default -> one.asText();
        };
    }

    /** This table with other rows in each field. */
    AnswerTable withRows(UnaryOperator<List<List<Object>>> change) {
        Map<String, List<List<Object>>> changed = new LinkedHashMap<>();
        fields.forEach((name, rows) -> changed.put(name, change.apply(rows)));
        return new AnswerTable(changed);
    }

    /** This table with other values, wherever they stand. */
    AnswerTable withValues(UnaryOperator<Object> change) {
        return withRows(
                rows -> rows.stream().map(row -> row.stream().map(change).toList()).toList());
    }

    Stream<List<Object>> rows() {
        return fields.values().stream().flatMap(List::stream);
    }

    Stream<Object> values() {
        return rows().flatMap(List::stream);
    }

    DoubleStream numbers() {
        return values().filter(Double.class::isInstance).mapToDouble(Double.class::cast);
    }

    /** How many different magnitudes above 0 there are. */
    long magnitudes() {
        return numbers().map(Math::abs).filter(one -> one > 0).distinct().count();
    }

    boolean allNumbers(DoublePredicate test) {
        return numbers().allMatch(test);
    }

    /** Whether the values are the same but for rounding. */
    boolean isSameAs(AnswerTable other) {
        return isSameAs(other, ROUNDING);
    }

    /**
     * Whether the values are the same.
     *
     * @param rounding part of the largest number by which two may differ
     */
    boolean isSameAs(AnswerTable other, double rounding) {
        if (!fields.keySet().equals(other.fields.keySet())) return false;
        double allowed =
                rounding * numbers().map(Math::abs).filter(Double::isFinite).max().orElse(0);
        return fields.keySet().stream()
                .allMatch(name -> areSame(fields.get(name), other.fields.get(name), allowed));
    }

    private static boolean areSame(
            List<List<Object>> rows, List<List<Object>> others, double allowed) {
        if (rows.size() != others.size()) return false;
        for (int i = 0; i < rows.size(); i++) {
            if (rows.get(i).size() != others.get(i).size()) return false;
            for (int k = 0; k < rows.get(i).size(); k++)
                if (!isSame(rows.get(i).get(k), others.get(i).get(k), allowed)) return false;
        }
        return true;
    }

    private static boolean isSame(Object one, Object other, double allowed) {
        if (one instanceof Double a && other instanceof Double b)
            return a.equals(b) || Math.abs(a - b) <= allowed;
        return Objects.equals(one, other);
    }
}
