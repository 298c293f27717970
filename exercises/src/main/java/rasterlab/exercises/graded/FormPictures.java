package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import rasterlab.engine.format.FieldKind;
import rasterlab.exercises.drawing.Agreement;
import rasterlab.exercises.drawing.PlaneFigure;
import rasterlab.exercises.drawing.PlanePictures;
import rasterlab.exercises.drawing.TableLabels;
import rasterlab.exercises.drawing.TablePictures;
import rasterlab.exercises.drawing.YAxis;
import rasterlab.exercises.score.CasePicture;

/**
 * Draws answers by what the topic's format says they are: pixels and pictures as a grid, what lies
 * in the plane to scale, all others as a table of their numbers.
 */
final class FormPictures {
    /** The share of the largest difference below which one is not marked, as rounding is. */
    private static final double SEEN = 0.01;

    /**
     * The share of the largest right number above which a difference is none of rounding, however
     * large others are: a hue in degrees is no measure of shares.
     */
    private static final double ROUNDED = 1e-5;

    private final FormFields fields;
    private final JsonNode exact;
    private final JsonNode actual;

    /**
     * @param exact the right answer as {@code ./lab run} gives it
     * @param actual one that is not right; the right one itself where that alone is asked for
     */
    FormPictures(FormFields fields, JsonNode exact, JsonNode actual) {
        this.fields = fields;
        this.exact = exact;
        this.actual = actual;
    }

    List<CasePicture> drawn() {
        List<CasePicture> pixels = new FormPixels(fields).pictures(exact, actual);
        if (!pixels.isEmpty()) return pixels;
        List<PlaneFigure> right = new FormFigures(fields).of(exact);
        List<PlaneFigure> mine = new FormFigures(fields).of(actual);
        boolean alike = right.equals(mine) && !exact.equals(actual);
        return right.isEmpty() && mine.isEmpty() || alike ? table() : plane(right, mine);
    }

    private List<CasePicture> plane(List<PlaneFigure> right, List<PlaneFigure> mine) {
        List<PlaneFigure> given = new FormFigures(fields).given();
        boolean points = !fields.answered(exact, FieldKind.POINTS).isEmpty();
        double tolerance = points ? SEEN * largestDifference() : 0;
        return PlanePictures.of(given, right, mine, tolerance, YAxis.UP);
    }

    private List<CasePicture> table() {
        List<String> labels = new ArrayList<>();
        double[][] right = rows(exact, labels);
        List<String> more = new ArrayList<>();
        double[][] mine = rows(actual, more);
        double seen = Math.min(SEEN * largestDifference(), ROUNDED * largest(right));
        return TablePictures.of(
                new TableLabels(more.size() > labels.size() ? more : labels, List.of()),
                right,
                mine,
                Agreement.within(seen));
    }

    /** The largest difference between numbers in the same place; 0 where all others are alike. */
    private double largestDifference() {
        double[][] right = rows(exact, new ArrayList<>());
        double[][] mine = rows(actual, new ArrayList<>());
        double largest = 0;
        for (int i = 0; i < Math.min(right.length, mine.length); i++)
            for (int j = 0; j < Math.min(right[i].length, mine[i].length); j++) {
                double apart = Math.abs(right[i][j] - mine[i][j]);
                if (Double.isFinite(apart)) largest = Math.max(largest, apart);
            }
        return largest;
    }

    /** The largest number of the table that is one; 0 where there is none. */
    private static double largest(double[][] rows) {
        return Stream.of(rows)
                .flatMapToDouble(DoubleStream::of)
                .map(Math::abs)
                .filter(Double::isFinite)
                .max()
                .orElse(0);
    }

    /**
     * A row for each innermost array and each number that stands in none.
     *
     * @param labels receives the place of each, such as {@code points[2]}
     */
    private static double[][] rows(JsonNode answer, List<String> labels) {
        List<double[]> rows = new ArrayList<>();
        answer.properties().forEach(one -> add(one.getKey(), one.getValue(), labels, rows));
        return rows.toArray(double[][]::new);
    }

    private static void add(
            String place, JsonNode value, List<String> labels, List<double[]> rows) {
        if (value.isObject()) {
            value.properties()
                    .forEach(one -> add(place + "." + one.getKey(), one.getValue(), labels, rows));
            return;
        }
        boolean nested = value.isArray() && value.size() > 0 && value.get(0).isContainerNode();
        if (!nested) {
            labels.add(place);
            rows.add(numbers(value));
            return;
        }
        for (int i = 0; i < value.size(); i++)
            add(place + "[" + i + "]", value.get(i), labels, rows);
    }

    private static double[] numbers(JsonNode value) {
        if (!value.isArray()) return new double[] {number(value)};
        var numbers = new double[value.size()];
        for (int i = 0; i < numbers.length; i++) numbers[i] = number(value.get(i));
        return numbers;
    }

    /** Truth as 1 and 0; NaN where there is no number. */
    static double number(JsonNode value) {
        if (value.isBoolean()) return value.booleanValue() ? 1 : 0;
        if (value.isNumber()) return value.doubleValue();
        try {
            return Double.parseDouble(value.asText());
        } catch (NumberFormatException none) {
            return Double.NaN;
        }
    }
}
