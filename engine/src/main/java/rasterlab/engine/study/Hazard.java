package rasterlab.engine.study;

import java.util.Map;

/**
 * A named input on which methods fail, with the verdict recorded for each method.
 *
 * @param name lower-case with hyphens
 * @param description one English sentence: what is special about the input
 * @param input what each method is given
 * @param recorded method name to the kind of verdict it is known to earn here
 * @param <I> one input of the topic
 */
public record Hazard<I>(
        String name, String description, I input, Map<String, Verdict.Kind> recorded) {
    public Hazard {
        recorded = Map.copyOf(recorded);
    }
}
