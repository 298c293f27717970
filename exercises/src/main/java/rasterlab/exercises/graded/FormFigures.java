package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.format.FieldKind;
import rasterlab.exercises.drawing.PlaneFigure;

/**
 * The figures of the plane that an answer is made of: polygons, triangles of the given polygon,
 * segments, points, and given points that belong to the answer.
 */
final class FormFigures {
    private static final int TRIANGLE = 3;

    private final FormFields fields;

    FormFigures(FormFields fields) {
        this.fields = fields;
    }

    /** The given figures, as far as they lie in the plane. */
    List<PlaneFigure> given() {
        List<PlaneFigure> given = new ArrayList<>();
        for (JsonNode one : fields.given(FieldKind.WINDOW)) window(one).ifPresent(given::add);
        for (JsonNode one : fields.given(FieldKind.POLYGON)) polygon(one).ifPresent(given::add);
        for (JsonNode one : fields.given(FieldKind.SEGMENTS)) segments(one, given);
        for (JsonNode one : fields.given(FieldKind.POINTS)) points(one, given);
        return given;
    }

    /** The figures of an answer; none where it does not lie in the plane. */
    List<PlaneFigure> of(JsonNode answer) {
        List<PlaneFigure> figures = new ArrayList<>();
        for (JsonNode all : fields.answered(answer, FieldKind.POLYGONS))
            for (JsonNode one : all) polygon(one).ifPresent(figures::add);
        for (JsonNode all : fields.answered(answer, FieldKind.TRIANGLES))
            for (JsonNode one : all) triangle(one).ifPresent(figures::add);
        for (JsonNode all : fields.answered(answer, FieldKind.SEGMENTS)) segments(all, figures);
        for (JsonNode all : fields.answered(answer, FieldKind.POINTS)) points(all, figures);
        for (JsonNode all : fields.answered(answer, FieldKind.CHOICE)) chosen(all, figures);
        return figures;
    }

    private void chosen(JsonNode choice, List<PlaneFigure> into) {
        JsonNode points = fields.one(FieldKind.POINTS);
        for (int i = 0; i < Math.min(choice.size(), points.size()); i++)
            if (choice.get(i).booleanValue()) point(points.get(i)).ifPresent(into::add);
    }

    private static Optional<PlaneFigure> window(JsonNode sides) {
        return sides.size() == 4 && sides.get(0).isNumber()
                ? Optional.of(
                        PlaneFigure.window(at(sides, 0), at(sides, 1), at(sides, 2), at(sides, 3)))
                : polygon(sides);
    }

    private static void segments(JsonNode segments, List<PlaneFigure> into) {
        for (JsonNode one : segments)
            if (one.size() == 4)
                into.add(PlaneFigure.segment(at(one, 0), at(one, 1), at(one, 2), at(one, 3)));
    }

    private static void points(JsonNode points, List<PlaneFigure> into) {
        for (JsonNode one : points) point(one).ifPresent(into::add);
    }

    private static Optional<PlaneFigure> point(JsonNode xy) {
        return xy.size() == 2
                ? Optional.of(PlaneFigure.point(at(xy, 0), at(xy, 1)))
                : Optional.empty();
    }

    private static Optional<PlaneFigure> polygon(JsonNode corners) {
        var numbers = new double[2 * corners.size()];
        for (int i = 0; i < corners.size(); i++) {
            if (corners.get(i).size() != 2) return Optional.empty();
            numbers[2 * i] = at(corners.get(i), 0);
            numbers[2 * i + 1] = at(corners.get(i), 1);
        }
        return numbers.length == 0 ? Optional.empty() : Optional.of(PlaneFigure.polygon(numbers));
    }

    /** Three corner numbers of the given polygon; none where one is no corner. */
    private Optional<PlaneFigure> triangle(JsonNode corners) {
        JsonNode polygon = fields.one(FieldKind.POLYGON);
        var numbers = new double[2 * TRIANGLE];
        for (int k = 0; k < TRIANGLE; k++) {
            JsonNode corner = polygon.path(corners.path(k).asInt(-1));
            if (corner.size() != 2) return Optional.empty();
            numbers[2 * k] = at(corner, 0);
            numbers[2 * k + 1] = at(corner, 1);
        }
        return Optional.of(PlaneFigure.polygon(numbers));
    }

    private static double at(JsonNode array, int index) {
        return FormPictures.number(array.get(index));
    }
}
