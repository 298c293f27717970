package rasterlab.engine.polygon.inside;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
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

/** Polygons and points on which methods fail, with what each method makes of them. */
final class InsideHazards {
    private static final Points DIAMOND = Points.of(0, -4, 4, 0, 0, 4, -4, 0);
    private static final Points BATTLEMENT =
            Points.of(0, 0, 9, 0, 9, 6, 6, 6, 6, 3, 3, 3, 3, 6, 0, 6);
    private static final Points CORNER_PIECE = Points.of(0, 0, 8, 0, 8, 3, 4, 3, 4, 6, 0, 6);
    private static final Points WIDE = Points.of(-4, -4, 4, -3, 0, 4);
    private static final Points PENTAGRAM = Points.of(0, 10, 6, -8, -10, 3, 10, 3, -6, -8);
    private static final Points FRACTIONS = Points.of(0.1, 0.1, 0.9, 0.3, 0.5, 0.4, 0.3, 0.8);

    private InsideHazards() {}

    static List<Hazard<ShapeAndPoints>> all() {
        return Stream.of(ofRays(), ofShapesAndNumbers()).flatMap(List::stream).toList();
    }

    /** Where a ray meets corners, edges or the boundary. */
    private static List<Hazard<ShapeAndPoints>> ofRays() {
        return List.of(
                hazard(
                        "no-corner-at-the-ray",
                        BATTLEMENT,
                        Points.of(1, 1, 4, 2, 1, 5, 4.5, 4, 7, 5, 10, 1),
                        recorded(EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "last-edge",
                        Points.of(6, 8, 0, 7, 1, 1, 9, 0),
                        Points.of(4, 4, 7, 3, 9, 5, -2, 4),
                        recorded(EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "ray-through-a-corner",
                        DIAMOND,
                        Points.of(-1, 0, -6, 0, -6, 4, -6, -4, 1, 0),
                        recorded(WRONG, EXACT, EXACT, EXACT)),
                hazard(
                        "ray-along-an-edge",
                        CORNER_PIECE,
                        Points.of(1, 3, -1, 3, -1, 6, 5, 6, -1, 0),
                        recorded(WRONG, EXACT, EXACT, EXACT)),
                hazard(
                        "on-the-boundary",
                        BATTLEMENT,
                        Points.of(0, 0, 9, 6, 4, 0, 9, 3, 4, 3, 0, 4, 1, 6, 3, 3),
                        recorded(DEGRADED, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "in-line-with-edges",
                        BATTLEMENT,
                        Points.of(9, 8, -2, 3, 6, 7, 3, -1, 4.5, 6, 1, 3, 0, -3, 8, 3),
                        recorded(EXACT, EXACT, EXACT, EXACT)));
    }

    /** Shapes that no picture begins with, and where digits or range run out. */
    private static List<Hazard<ShapeAndPoints>> ofShapesAndNumbers() {
        return List.of(
                hazard(
                        "two-steps-from-the-edges",
                        FRACTIONS,
                        NearSides.of(FRACTIONS, 500, 2, new Random(1997)),
                        recorded(DEGRADED, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "covered-twice",
                        PENTAGRAM,
                        Points.of(0, 0, 1, 1, 0, 8, 6, 2.5, 0, -7),
                        recorded(EXACT, EXACT, WRONG, EXACT)),
                hazard(
                        "repeated-corners",
                        Points.of(0, 0, 0, 0, 8, 0, 8, 0, 8, 9, 8, 0, 5, 7, 5, 7),
                        Points.of(4, 1, 4, 6, 7, 1, 9, 1, 8, 8),
                        recorded(DEGRADED, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "no-area",
                        Points.of(0, 0, 6, 3, 2, 1),
                        Points.of(4, 2, 1, 1, 8, 4, -2, -1),
                        recorded(WRONG, DEGRADED, DEGRADED, EXACT)),
                hazard(
                        "huge",
                        WIDE.scaled(0.4e308),
                        Points.of(1, 1, -1, 2, 3, 3, -3, 2).scaled(0.4e308),
                        recorded(WRONG, WRONG, WRONG, EXACT)),
                hazard(
                        "tiny",
                        DIAMOND.scaled(1e-200),
                        Points.of(1, 1, -1, 2, 3, 3, -3, 2).scaled(1e-200),
                        recorded(EXACT, EXACT, WRONG, EXACT)));
    }

    private static Hazard<ShapeAndPoints> hazard(
            String name, Points corners, Points points, Map<String, Verdict.Kind> recorded) {
        return new Hazard<>(name, new ShapeAndPoints(corners, points), recorded);
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind rayNaive, Verdict.Kind ray, Verdict.Kind winding, Verdict.Kind robust) {
        return Map.of("ray-naive", rayNaive, "ray", ray, "winding", winding, "robust", robust);
    }
}
