package rasterlab.engine.transform.rotate;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Angles and numbers of turns on which cheap rotations fail. */
final class RotateHazards {
    private static final String DIRECT = "direct";
    private static final String FLOAT = "float";
    private static final String TABLE = "table";
    private static final String TEXTBOOK = "buneman-textbook";
    private static final String BUNEMAN = "buneman";
    private static final String ORTHONORMAL = "orthonormal";
    private static final String QUATERNION = "quaternion";

    private RotateHazards() {}

    static List<Hazard<Turns>> all() {
        return Stream.of(angles(), halfTurns(), drift(), sizes()).flatMap(List::stream).toList();
    }

    private static List<Hazard<Turns>> angles() {
        return List.of(
                hazard(
                        "whole-degrees",
                        new Turns(37, 1, new double[] {3, 4}),
                        Map.of(FLOAT, DEGRADED)),
                hazard("quarter-turn", new Turns(90, 1, new double[] {3, 4}), Map.of()),
                hazard(
                        "between-degrees",
                        new Turns(12.5, 1, new double[] {3, 4}),
                        Map.of(FLOAT, DEGRADED, TABLE, DEGRADED)));
    }

    private static List<Hazard<Turns>> halfTurns() {
        return List.of(
                hazard(
                        "half-turn",
                        new Turns(180, 1, new double[] {3, 4}),
                        Map.of(TEXTBOOK, WRONG)),
                hazard(
                        "nearly-half-turn",
                        new Turns(180 - 1e-6, 1, new double[] {3, 4}),
                        Map.of(FLOAT, DEGRADED, TABLE, DEGRADED, TEXTBOOK, DEGRADED)));
    }

    private static List<Hazard<Turns>> drift() {
        return List.of(
                hazard(
                        "hundred-thousand-turns",
                        new Turns(0.1, 100_000, new double[] {60, 80}),
                        Map.of(
                                DIRECT,
                                DEGRADED,
                                FLOAT,
                                DEGRADED,
                                TABLE,
                                WRONG,
                                TEXTBOOK,
                                DEGRADED,
                                BUNEMAN,
                                DEGRADED,
                                ORTHONORMAL,
                                DEGRADED,
                                QUATERNION,
                                DEGRADED)),
                hazard(
                        "ten-million-turns",
                        new Turns(33.3, 10_000_000, new double[] {60, 80}),
                        Map.of(
                                DIRECT,
                                DEGRADED,
                                FLOAT,
                                WRONG,
                                TABLE,
                                WRONG,
                                TEXTBOOK,
                                DEGRADED,
                                BUNEMAN,
                                DEGRADED,
                                ORTHONORMAL,
                                DEGRADED,
                                QUATERNION,
                                DEGRADED)));
    }

    private static List<Hazard<Turns>> sizes() {
        return List.of(
                hazard(
                        "huge-angle",
                        new Turns(360e15 + 64, 1, new double[] {3, 4}),
                        Map.of(FLOAT, DEGRADED)),
                hazard(
                        "beyond-float",
                        new Turns(45, 1, new double[] {3e200, -4e200}),
                        Map.of(FLOAT, REFUSED)));
    }

    private static Hazard<Turns> hazard(
            String name, Turns turns, Map<String, Verdict.Kind> failing) {
        return Hazard.allExactBut(failing, RotateMethods.all(), name, turns);
    }
}
