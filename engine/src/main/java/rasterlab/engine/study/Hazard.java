package rasterlab.engine.study;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A named input on which methods fail, with the verdict recorded for each method. What is special
 * about the input stands in the lab's texts, under its name.
 *
 * @param name lower-case with hyphens
 * @param input what each method is given
 * @param recorded method name to the kind of verdict it is known to earn here
 * @param <I> one input of the topic
 */
public record Hazard<I>(String name, I input, Map<String, Verdict.Kind> recorded) {
    public Hazard {
        recorded = Map.copyOf(recorded);
    }

    /**
     * A hazard on which all {@code methods} are exact but for those that are named.
     *
     * @param failing method name to what it is known to earn here
     */
    public static <C, I> Hazard<I> allExactBut(
            Map<String, Verdict.Kind> failing, List<Method<C>> methods, String name, I input) {
        var recorded = new TreeMap<String, Verdict.Kind>();
        for (Method<C> method : methods) recorded.put(method.name(), Verdict.Kind.EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, input, recorded);
    }
}
