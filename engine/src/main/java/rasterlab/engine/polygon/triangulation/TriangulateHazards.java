package rasterlab.engine.polygon.triangulation;

import static rasterlab.engine.study.Verdict.Kind.CRASHED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Polygons on which methods fail, with what each method makes of them. */
final class TriangulateHazards {
    private static final Points HEXAGON = Points.of(2, 0, 5, 0, 7, 3, 5, 6, 2, 6, 0, 3);
    private static final Points CORNER_PIECE = Points.of(0, 0, 8, 0, 8, 3, 4, 3, 4, 6, 0, 6);

    /** A polygon found by random search; its three corners 2, 3, 0 have corner 1 between them. */
    private static final Points ARROW = Points.of(5, 6, 6, 4, 4, 3, 8, 1);

    private static final Points KEYHOLE =
            Points.of(0, 0, 6, 0, 6, 6, 0, 6, 0, 0, 2, 2, 2, 4, 4, 4, 4, 2, 2, 2);

    private static final Points PENTAGRAM = Points.of(0, 10, -6, -8, 10, 3, -10, 3, 6, -8);

    private TriangulateHazards() {}

    static List<Hazard<Points>> all() {
        return Stream.of(ofShapes(), ofNumbersAndFaults()).flatMap(List::stream).toList();
    }

    /** Simple polygons in handy numbers. */
    private static List<Hazard<Points>> ofShapes() {
        return List.of(
                hazard(
                        "one-triangle",
                        Points.of(0, 0, 4, 0, 0, 3),
                        recorded(EXACT, EXACT, EXACT, EXACT)),
                hazard("convex", HEXAGON, recorded(EXACT, EXACT, EXACT, EXACT)),
                hazard("not-convex", CORNER_PIECE, recorded(REFUSED, EXACT, EXACT, EXACT)),
                hazard(
                        "fan-leaves",
                        Points.of(8, 0, 8, 3, 4, 3, 4, 6, 0, 6, 0, 0),
                        recorded(REFUSED, EXACT, EXACT, EXACT)),
                hazard("corner-in-the-ear", ARROW, recorded(REFUSED, WRONG, EXACT, EXACT)),
                hazard("clockwise", HEXAGON.reversed(), recorded(EXACT, WRONG, EXACT, EXACT)),
                hazard(
                        "corners-on-a-side",
                        Points.of(0, 0, 2, 0, 4, 0, 6, 0, 6, 6, 3, 6, 0, 6, 0, 1),
                        recorded(REFUSED, EXACT, EXACT, EXACT)),
                hazard(
                        "one-long-side",
                        Points.of(0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 3, 9),
                        recorded(REFUSED, WRONG, EXACT, EXACT)));
    }

    /** Where digits or range run out, and what is no simple polygon. */
    private static List<Hazard<Points>> ofNumbersAndFaults() {
        return List.of(
                hazard(
                        "repeated-corners",
                        Points.of(0, 0, 8, 0, 8, 0, 8, 3, 4, 3, 4, 3, 4, 3, 4, 6, 0, 6, 0, 0),
                        recorded(REFUSED, WRONG, EXACT, EXACT)),
                hazard(
                        "small-units",
                        CORNER_PIECE.scaled(1e-4),
                        recorded(REFUSED, WRONG, EXACT, EXACT)),
                hazard(
                        "diagonals-beyond-10-15",
                        CORNER_PIECE.scaled(1e16),
                        recorded(REFUSED, WRONG, EXACT, EXACT)),
                hazard(
                        "coordinates-of-10-308",
                        CORNER_PIECE.scaled(0.2e308),
                        recorded(REFUSED, WRONG, EXACT, EXACT)),
                hazard(
                        "one-step-from-straight",
                        nearlyStraight(),
                        recorded(REFUSED, EXACT, EXACT, EXACT)),
                hazard("crossing-edges", PENTAGRAM, recorded(REFUSED, WRONG, REFUSED, REFUSED)),
                hazard("keyhole", KEYHOLE, recorded(REFUSED, EXACT, EXACT, EXACT)),
                hazard(
                        "hole-the-wrong-way",
                        Points.of(0, 0, 6, 0, 6, 6, 0, 6, 0, 0, 2, 2, 4, 2, 4, 4, 2, 4, 2, 2),
                        recorded(REFUSED, WRONG, REFUSED, REFUSED)),
                hazard(
                        "touching-corner",
                        Points.of(0, 0, 8, 0, 8, 6, 4, 0, 0, 6),
                        recorded(REFUSED, WRONG, REFUSED, REFUSED)),
                hazard(
                        "no-area",
                        Points.of(0, 0, 2, 1, 6, 3, 4, 2),
                        recorded(REFUSED, WRONG, REFUSED, REFUSED)));
    }

    /** A square whose lower side bends up and down by the least that doubles can tell. */
    private static Points nearlyStraight() {
        double up = Math.nextUp(0.1);
        double down = Math.nextDown(0.1);
        return Points.of(0.1, 0.1, 0.3, up, 0.5, down, 0.7, up, 0.9, 0.1, 0.9, 0.9, 0.1, 0.9);
    }

    private static Hazard<Points> hazard(
            String name, Points corners, Map<String, Verdict.Kind> recorded) {
        return new Hazard<>(name, corners, recorded);
    }

    /** The listing as printed crashes at its first turn, whatever the polygon. */
    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind fan,
            Verdict.Kind shortestDiagonalTextbook,
            Verdict.Kind shortestDiagonal,
            Verdict.Kind earClipping) {
        return Map.of(
                "fan", fan,
                "shortest-diagonal-printed-textbook", CRASHED,
                "shortest-diagonal-textbook", shortestDiagonalTextbook,
                "shortest-diagonal", shortestDiagonal,
                "ear-clipping", earClipping);
    }
}
