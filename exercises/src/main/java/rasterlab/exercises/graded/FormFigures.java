package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.drawing.PlaneFigure;

/**
 * The figures of the plane that an answer is made of: {@code polygons}, {@code triangles} of the
 * given polygon, {@code segments}, {@code points}, and given points that are {@code inside}.
 */
final class FormFigures {
    private static final int TRIANGLE = 3;

    private final JsonNode input;

    FormFigures(JsonNode input) {
        this.input = input;
    }

    /** What is given, as far as it lies in the plane. */
    List<PlaneFigure> given() {
        List<PlaneFigure> given = new ArrayList<>();
        JsonNode window = input.path("window");
        if (window.size() == 4 && window.get(0).isNumber())
            given.add(
                    PlaneFigure.window(at(window, 0), at(window, 1), at(window, 2), at(window, 3)));
        else polygon(window).ifPresent(given::add);
        for (String shape : List.of("polygon", "triangle"))
            polygon(input.path(shape)).ifPresent(given::add);
        segments(input.path("segments"), given);
        if (!input.has("inside")) points(input.path("points"), given);
        return given;
    }

    /** Those of an answer; none where it does not lie in the plane. */
    List<PlaneFigure> of(JsonNode answer) {
        List<PlaneFigure> figures = new ArrayList<>();
        for (JsonNode one : answer.path("polygons")) polygon(one).ifPresent(figures::add);
        for (JsonNode one : answer.path("triangles")) triangle(one).ifPresent(figures::add);
        segments(answer.path("segments"), figures);
        points(answer.path("points"), figures);
        JsonNode inside = answer.path("inside");
        JsonNode points = input.path("points");
        for (int i = 0; i < Math.min(inside.size(), points.size()); i++)
            if (inside.get(i).booleanValue()) point(points.get(i)).ifPresent(figures::add);
        return figures;
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
        JsonNode polygon = input.path("polygon");
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
