package rasterlab.exercises.property;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangulation.Triangles;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.Relation.Equivalence;
import rasterlab.exercises.score.Message;

/** Properties of areas: triangles of a polygon have its area together. */
final class AreaProperties {
    /**
     * The tolerance as a share of the polygon's area; sums of a few products are rounded by far
     * less.
     */
    private static final double ROUNDING = 1e-9;

    static final List<Property<Points, Triangles>> ALL =
            List.of(Property.always("triangulate", "area-kept", new AreaKept()));

    private AreaProperties() {}

    /** Twice the area, above 0 where it is gone round counter-clockwise. */
    private static double doubled(Points corners) {
        double sum = 0;
        for (int i = 0; i < corners.size(); i++)
            sum += turn(corners, 0, i, (i + 1) % corners.size());
        return sum;
    }

    private static double turn(Points corners, int a, int b, int c) {
        return (corners.x(b) - corners.x(a)) * (corners.y(c) - corners.y(a))
                - (corners.y(b) - corners.y(a)) * (corners.x(c) - corners.x(a));
    }

    /** Twice the areas of all, each taken as positive; NaN where one has a corner that is none. */
    private static double doubled(Points corners, Triangles triangles) {
        double sum = 0;
        for (int i = 0; i < triangles.size(); i++) {
            for (int each = 0; each < 3; each++) {
                int corner = triangles.corner(i, each);
                if (corner < 0 || corner >= corners.size()) return Double.NaN;
            }
            sum +=
                    Math.abs(
                            turn(
                                    corners,
                                    triangles.corner(i, 0),
                                    triangles.corner(i, 1),
                                    triangles.corner(i, 2)));
        }
        return sum;
    }

    /** The relation of the polygon's area and that of the triangles. */
    private static final class AreaKept implements Relation<Points, Triangles> {
        @Override
        public List<Points> furtherInputs(Points corners, Triangles answer) {
            return List.of();
        }

        @Override
        public Optional<Broken<Points, Triangles>> broken(
                AnsweredInput<Points, Triangles> first,
                List<AnsweredInput<Points, Triangles>> beside,
                Equivalence<Points, Triangles> alike) {
            double area = Math.abs(doubled(first.input()));
            double sum = doubled(first.input(), first.output());
            if (Math.abs(sum - area) <= ROUNDING * area) return Optional.empty();
            return Optional.of(
                    new Broken<>(
                            first,
                            Optional.empty(),
                            Message.of("property.areas", sum / 2, area / 2)));
        }
    }
}
