package rasterlab.engine.visibility.faces;

import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Bodies and eyes on which methods fail, with what each makes of them. */
final class VisibleFacesHazards {
    private VisibleFacesHazards() {}

    static List<Hazard<Body>> all() {
        return Stream.of(ofEyes(), ofInnerPoints(), ofNumbers()).flatMap(List::stream).toList();
    }

    private static List<Hazard<Body>> ofEyes() {
        return List.of(
                hazard("cube", Bodies.cube(5, -6, 7), recorded(EXACT, EXACT)),
                hazard("edge-on", Bodies.cube(5, -6, 1), recorded(EXACT, EXACT)),
                hazard("edge-on-by-rounding", nearlyEdgeOn(), recorded(WRONG, EXACT)),
                hazard("eye-inside", Bodies.cube(0.5, 0.25, -0.5), recorded(EXACT, EXACT)));
    }

    private static List<Hazard<Body>> ofInnerPoints() {
        return List.of(
                hazard("not-convex", Bodies.corner(6, 7, 5), recorded(WRONG, REFUSED)),
                hazard(
                        "not-convex-but-star-shaped",
                        Bodies.corner(6, 7, 5).withInside(0.5, 0.5, 0.5),
                        recorded(EXACT, EXACT)),
                hazard(
                        "inner-point-outside",
                        Bodies.cube(5, -6, 7).withInside(-3, 3, -3),
                        recorded(WRONG, REFUSED)),
                hazard(
                        "inner-point-before-a-face",
                        Bodies.cube(5, -6, 7).withInside(2, 0, 0),
                        recorded(WRONG, REFUSED)),
                hazard(
                        "parallel",
                        Bodies.cube(5, -6, 7).withInside(5, 0, 0),
                        recorded(WRONG, REFUSED)),
                hazard("no-area", sliver(), recorded(EXACT, REFUSED)));
    }

    private static List<Hazard<Body>> ofNumbers() {
        return List.of(
                hazard("corner-on-an-edge", cornerOnEdge(), recorded(WRONG, EXACT)),
                hazard("huge", Bodies.cube(5, -6, 7).scaled(1e200), recorded(WRONG, EXACT)),
                hazard("tiny", Bodies.cube(5, -6, 7).scaled(1e-200), recorded(WRONG, EXACT)),
                hazard("wall-at-the-largest", wallAtTheLargest(), recorded(WRONG, REFUSED)));
    }

    /** Both sides of a triangle; the eye is four steps of the largest double before it. */
    private static Body wallAtTheLargest() {
        double x = Double.MAX_VALUE;
        double step = Math.ulp(x);
        return Body.seenFrom(
                new double[] {x - 4 * step, step, step},
                new double[] {x, 0, 0, x, 0, 8 * step, x, 8 * step, 0},
                new int[] {0, 1, 2},
                new int[] {0, 2, 1});
    }

    /** The slanting face of a tetrahedron passes the eye by 3·10⁻¹⁷. */
    private static Body nearlyEdgeOn() {
        return Body.seenFrom(
                new double[] {0.1, 1.3, -0.4},
                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
                new int[] {0, 2, 1},
                new int[] {0, 1, 3},
                new int[] {0, 3, 2},
                new int[] {1, 2, 3});
    }

    private static Body cornerOnEdge() {
        return Body.seenFrom(
                new double[] {3, 4, 5},
                new double[] {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 2, 2, 0, 2, 0, 2, 2},
                new int[] {0, 2, 1},
                new int[] {3, 4, 5, 6},
                new int[] {0, 1, 5, 4, 3},
                new int[] {1, 2, 6, 5},
                new int[] {2, 0, 3, 6});
    }

    private static Body sliver() {
        return Body.seenFrom(
                new double[] {3, 4, 5},
                new double[] {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 0},
                new int[] {0, 2, 1, 4},
                new int[] {0, 1, 4},
                new int[] {0, 1, 3},
                new int[] {0, 3, 2},
                new int[] {1, 2, 3});
    }

    private static Hazard<Body> hazard(String name, Body body, Map<String, Verdict.Kind> recorded) {
        return new Hazard<>(name, body, recorded);
    }

    private static Map<String, Verdict.Kind> recorded(Verdict.Kind textbook, Verdict.Kind segment) {
        return Map.of(
                "back-face", EXACT,
                "convex-segment-textbook", textbook,
                "convex-segment", segment);
    }
}
