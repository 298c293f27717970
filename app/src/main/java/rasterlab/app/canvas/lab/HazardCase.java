package rasterlab.app.canvas.lab;

import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/**
 * A hazard as a lab offers it, or another scene that is worth a look.
 *
 * @param name as on the command line
 * @param label what the chip says
 * @param special one sentence: what is special about the input
 * @param methods in teaching order; none where no method is judged by it
 * @param recorded method name to the verdict it is known to earn here
 * @param show shows the input in the lab
 */
public record HazardCase(
        String name,
        String label,
        String special,
        List<String> methods,
        Map<String, Verdict.Kind> recorded,
        Runnable show) {
    public HazardCase {
        methods = List.copyOf(methods);
        recorded = Map.copyOf(recorded);
    }

    /** A hazard of a topic, with the verdicts of those methods that a lab offers. */
    public static HazardCase of(
            Hazard<?> hazard, String label, String special, List<String> methods, Runnable show) {
        return new HazardCase(hazard.name(), label, special, methods, hazard.recorded(), show);
    }

    /** A scene whose verdicts are still to be found, or which has none. */
    public static HazardCase unjudged(String name, String label, String special, Runnable show) {
        return new HazardCase(name, label, special, List.of(), Map.of(), show);
    }

    /** This case with verdicts, in teaching order. */
    public HazardCase judged(Map<String, Verdict.Kind> found) {
        return new HazardCase(name, label, special, List.copyOf(found.keySet()), found, show);
    }

    /** The methods that do not answer exactly here, in teaching order. */
    List<String> failing() {
        return methods.stream()
                .filter(recorded::containsKey)
                .filter(method -> recorded.get(method) != Verdict.Kind.EXACT)
                .toList();
    }
}
