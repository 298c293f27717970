package rasterlab.engine.transform.rotate;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.HashMap;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Angles and numbers of turns on which cheap rotations fail. */
final class RotateHazards {
    private static final List<String> METHODS =
            List.of(
                    "direct",
                    "float",
                    "table",
                    "buneman-textbook",
                    "buneman",
                    "orthonormal",
                    "quaternion");

    private RotateHazards() {}

    static List<Hazard<Turns>> all() {
        return Stream.of(angles(), halfTurns(), drift(), sizes()).flatMap(List::stream).toList();
    }

    private static List<Hazard<Turns>> angles() {
        return List.of(
                hazard(
                        "whole-degrees",
                        "An angle that the table has.",
                        new Turns(37, 1, new double[] {3, 4}),
                        EXACT,
                        DEGRADED,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "between-degrees",
                        "Half a degree beside every entry of the table.",
                        new Turns(12.5, 1, new double[] {3, 4}),
                        EXACT,
                        DEGRADED,
                        DEGRADED,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<Turns>> halfTurns() {
        return List.of(
                hazard(
                        "half-turn",
                        "θ = 180°: tan θ/2 is tan 90°.",
                        new Turns(180, 1, new double[] {3, 4}),
                        EXACT,
                        EXACT,
                        EXACT,
                        WRONG,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "nearly-half-turn",
                        "A millionth of a degree before 180°: tan θ/2 is about 10⁸.",
                        new Turns(180 - 1e-6, 1, new double[] {3, 4}),
                        EXACT,
                        DEGRADED,
                        DEGRADED,
                        DEGRADED,
                        EXACT,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<Turns>> drift() {
        return List.of(
                hazard(
                        "hundred-thousand-turns",
                        "A hundred thousand turns by 0.1°, which the table takes for 0°.",
                        new Turns(0.1, 100_000, new double[] {60, 80}),
                        DEGRADED,
                        DEGRADED,
                        WRONG,
                        DEGRADED,
                        DEGRADED,
                        DEGRADED,
                        DEGRADED),
                hazard(
                        "ten-million-turns",
                        "Ten million turns by 33.3°: roundings add up.",
                        new Turns(33.3, 10_000_000, new double[] {60, 80}),
                        DEGRADED,
                        WRONG,
                        WRONG,
                        DEGRADED,
                        DEGRADED,
                        DEGRADED,
                        DEGRADED));
    }

    private static List<Hazard<Turns>> sizes() {
        return List.of(
                hazard(
                        "huge-angle",
                        "10¹⁵ turns and 64° in one angle.",
                        new Turns(360e15 + 64, 1, new double[] {3, 4}),
                        EXACT,
                        DEGRADED,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "beyond-float",
                        "Coordinates that a float cannot hold.",
                        new Turns(45, 1, new double[] {3e200, -4e200}),
                        EXACT,
                        REFUSED,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT,
                        EXACT));
    }

    /**
     * @param kinds in the order of {@link #METHODS}; total-angle is exact everywhere
     */
    private static Hazard<Turns> hazard(
            String name, String description, Turns turns, Verdict.Kind... kinds) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (int i = 0; i < kinds.length; i++) recorded.put(METHODS.get(i), kinds[i]);
        recorded.put("total-angle", EXACT);
        return new Hazard<>(name, description, turns, recorded);
    }
}
