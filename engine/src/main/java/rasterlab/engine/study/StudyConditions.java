package rasterlab.engine.study;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import rasterlab.engine.study.measuring.Machine;

/**
 * How a study was measured, so that it can be repeated and believed.
 *
 * @param begun when it was begun
 * @param machine where
 * @param loadBefore processes that wanted to run in the minute before, as the system tells it;
 *     negative where it does not
 * @param loadAfter the same at the end
 * @param fixed times of a load that never changes, in nanoseconds per step, round by round: the
 *     machine's noise beside each workload, by its name
 * @param whole whether it came to its end; what was measured before it was cancelled is there
 */
public record StudyConditions(
        StudySettings settings,
        Instant begun,
        Machine machine,
        double loadBefore,
        double loadAfter,
        Map<String, List<Double>> fixed,
        boolean whole) {
    public StudyConditions {
        fixed = Map.copyOf(fixed);
    }
}
