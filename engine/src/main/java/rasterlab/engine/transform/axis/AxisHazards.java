package rasterlab.engine.transform.axis;

import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Axes on which the printed seven steps fail, and those that are hard for the right methods. */
final class AxisHazards {
    private static final double THIRD = 1 / 3.0;
    private static final double TINY = Double.MIN_VALUE;

    private AxisHazards() {}

    static List<Hazard<AxisTurn>> all() {
        return Stream.of(turns(), axesAlongZ(), sizes()).flatMap(List::stream).toList();
    }

    private static List<Hazard<AxisTurn>> turns() {
        return List.of(
                hazard("no-turn", AxisTurn.about(1, 2, 2, 0, 5, -3, 8), EXACT),
                hazard("quarter-turn", AxisTurn.about(1, 2, 2, 90, 3, 0, 0), WRONG),
                hazard(
                        "axis-itself",
                        AxisTurn.about(
                                THIRD, 2 * THIRD, 2 * THIRD, 37, THIRD, 2 * THIRD, 2 * THIRD),
                        WRONG),
                hazard("axis-along-x", AxisTurn.about(1, 0, 0, 30, 3, 4, 5), WRONG));
    }

    private static List<Hazard<AxisTurn>> axesAlongZ() {
        return List.of(
                hazard("axis-along-z", AxisTurn.about(0, 0, 2, 90, 1, 0, 7), WRONG),
                hazard("axis-against-z", AxisTurn.about(0, 0, -0.5, 90, 1, 0, 7), WRONG),
                hazard("axis-nearly-z", AxisTurn.about(3e-170, -4e-170, 1, 45, 1, 2, 3), WRONG),
                hazard("axis-beside-z", AxisTurn.about(TINY, TINY, 1, 45, 1, 0, 0), WRONG));
    }

    private static List<Hazard<AxisTurn>> sizes() {
        return List.of(
                hazard(
                        "axis-through-far-point",
                        new AxisTurn(
                                new double[] {1e9, -2e9, 1e9},
                                new double[] {1, 1, 1},
                                120,
                                new double[] {1e9 + 1, -2e9, 1e9, 0, 0, 0}),
                        WRONG),
                hazard("huge-direction", AxisTurn.about(1e300, -1e300, 1e300, 100, 1, 2, 3), WRONG),
                hazard(
                        "tiny-direction",
                        AxisTurn.about(1e-320, 2e-320, 2e-320, 100, 1, 2, 3),
                        WRONG),
                hazard("many-turns", AxisTurn.about(1, -1, 0.5, 3_600_000_001.0, 1, 2, 3), WRONG));
    }

    private static Hazard<AxisTurn> hazard(String name, AxisTurn turn, Verdict.Kind textbook) {
        return Hazard.allExactBut(
                Map.of("seven-steps-textbook", textbook), AxisMethods.all(), name, turn);
    }
}
