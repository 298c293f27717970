package rasterlab.engine.polygon.triangle;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import rasterlab.engine.polygon.NearSides;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Triangles and points on which methods fail, with what each method makes of them. */
final class TriangleHazards {
    private static final Points COUNTER_CLOCKWISE = Points.of(0, 0, 8, 1, 3, 7);
    private static final Points RIGHT_ANGLED = Points.of(2, 1, 10, 1, 2, 7);
    private static final Points ON_ITS_SIDES = Points.of(2, 1, 10, 1, 2, 7, 6, 1, 2, 3, 6, 4);
    private static final Points ON_ONE_LINE = Points.of(1, 1, 3, 3, 7, 7);
    private static final Points FRACTIONS = Points.of(0.1, 0.1, 0.9, 0.3, 0.3, 0.8);
    private static final Points LARGE = Points.of(-30000, -30000, 31000, -29000, 500, 32000);

    private TriangleHazards() {}

    static List<Hazard<ShapeAndPoints>> all() {
        return Stream.of(ofPictures(), ofNumbers()).flatMap(List::stream).toList();
    }

    /** The hazards in the whole numbers of pictures. */
    private static List<Hazard<ShapeAndPoints>> ofPictures() {
        return List.of(
                hazard(
                        "well-inside-and-outside",
                        COUNTER_CLOCKWISE,
                        Points.of(3, 3, 5, 3, 9, 9, -1, 0, 4, -1, 3, 8),
                        recorded(EXACT, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "boundary-one-way-round",
                        RIGHT_ANGLED.reversed(),
                        ON_ITS_SIDES,
                        recorded(EXACT, DEGRADED, EXACT, EXACT, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "boundary-other-way-round",
                        RIGHT_ANGLED,
                        ON_ITS_SIDES,
                        recorded(EXACT, DEGRADED, EXACT, DEGRADED, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "minus-zero",
                        Points.of(4, 0, 0, 0, 0, 4),
                        Points.of(4, 0, 1, 1, 5, 5),
                        recorded(EXACT, DEGRADED, EXACT, EXACT, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "past-2-15",
                        LARGE.scaled(2),
                        Points.of(0, 0, 60000, 60000, -60000, 60000, 1000, -40000),
                        recorded(EXACT, EXACT, EXACT, WRONG, EXACT, EXACT, EXACT)));
    }

    /** Where area, digits or range run out. */
    private static List<Hazard<ShapeAndPoints>> ofNumbers() {
        return List.of(
                hazard(
                        "corners-on-one-line",
                        ON_ONE_LINE,
                        Points.of(2, 2, 7, 7, 9, 9, 0, 0, 4, 5),
                        recorded(WRONG, DEGRADED, REFUSED, WRONG, WRONG, WRONG, EXACT)),
                hazard(
                        "corners-in-one-point",
                        Points.of(4, 4, 4, 4, 4, 4),
                        Points.of(4, 4, 5, 4, 4, 3),
                        recorded(WRONG, EXACT, REFUSED, WRONG, WRONG, WRONG, EXACT)),
                hazard(
                        "fractions",
                        FRACTIONS,
                        Points.of(0.4, 0.4, 0.5, 0.25, 0.9, 0.9),
                        recorded(EXACT, EXACT, EXACT, REFUSED, EXACT, EXACT, EXACT)),
                hazard(
                        "two-steps-from-the-sides",
                        FRACTIONS,
                        NearSides.of(FRACTIONS, 500, 2, new Random(1997)),
                        recorded(DEGRADED, DEGRADED, DEGRADED, REFUSED, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "small-and-far-away",
                        Points.of(1e9, 1e9, 1e9 + 2, 1e9, 1e9, 1e9 + 2),
                        Points.of(1e9 + 0.5, 1e9 + 0.5, 1e9 + 2, 1e9 + 2, 1e9 - 1, 1e9 + 1),
                        recorded(EXACT, EXACT, EXACT, REFUSED, WRONG, EXACT, EXACT)),
                hazard(
                        "smaller-than-any-epsilon",
                        COUNTER_CLOCKWISE.scaled(1e-7),
                        Points.of(3, 3, 5, 3, 9, 9, -1, 0, 4, -1, 3, 8).scaled(1e-7),
                        recorded(EXACT, EXACT, EXACT, REFUSED, EXACT, EXACT, EXACT)),
                hazard(
                        "huge",
                        COUNTER_CLOCKWISE.scaled(1e200),
                        Points.of(3, 3, 9, 9, -1, 0, 3, 8, 9, 2, 12, 3).scaled(1e200),
                        recorded(WRONG, EXACT, REFUSED, REFUSED, REFUSED, WRONG, EXACT)),
                hazard(
                        "products-just-overflow",
                        Points.of(1.5e154, 0, 1.5e154, 1.2e154, 1.4e154, 1.1e154),
                        Points.of(1.52e154, 0.6e154, 1.48e154, 0.6e154, 1.46e154, 1.1e154),
                        recorded(WRONG, EXACT, EXACT, REFUSED, REFUSED, EXACT, EXACT)),
                hazard(
                        "tiny",
                        COUNTER_CLOCKWISE.scaled(1e-200),
                        Points.of(3, 3, 9, 9, -1, 0, 3, 8).scaled(1e-200),
                        recorded(WRONG, EXACT, REFUSED, REFUSED, WRONG, WRONG, EXACT)));
    }

    private static Hazard<ShapeAndPoints> hazard(
            String name, Points corners, Points points, Map<String, Verdict.Kind> recorded) {
        return new Hazard<>(name, new ShapeAndPoints(corners, points), recorded);
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind halfPlane,
            Verdict.Kind rotation,
            Verdict.Kind simplex,
            Verdict.Kind signInt,
            Verdict.Kind signFloat,
            Verdict.Kind signDouble,
            Verdict.Kind robust) {
        return Map.of(
                "half-plane", halfPlane,
                "rotation", rotation,
                "simplex", simplex,
                "sign-int", signInt,
                "sign-float", signFloat,
                "sign-double", signDouble,
                "robust", robust);
    }
}
