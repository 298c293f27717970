package rasterlab.exercises.proving;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Breaking;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.breaking.HandedInputs;
import rasterlab.exercises.judging.InputJson;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.score.Phrase;

/**
 * Proves an exercise that asks for inputs on which faulty methods fail: each of them fails on one
 * of the topic's hazards, on which the methods that promise to be right agree.
 */
final class BreakProving {
    private final Exercise exercise;
    private final Topic<?, ?, ?> topic;
    private final List<Sample> samples;

    private BreakProving(Exercise exercise) {
        this.exercise = exercise;
        this.topic = Topics.named(exercise.topic());
        this.samples = samples(topic);
    }

    /** An input of a hazard as it can be handed in. */
    private record Sample(String hazard, String json, boolean forMutants) {}

    /**
     * The proof without the starter.
     *
     * @param seed kept in the proof; nothing is drawn
     */
    static Proof of(Exercise exercise, long seed) {
        BreakProving proving = new BreakProving(exercise);
        List<RightMethod> right = new ArrayList<>();
        int points = exercise.points().accuracy();
        for (Method<?> one : proving.topic.methods())
            if (one.promisesToBeRight())
                right.add(
                        new RightMethod(
                                one.name(), true, points, 0, List.of(), List.of(), List.of()));
        // A topic whose methods all have a weakness is judged by its exact answers alone.
        if (right.isEmpty())
            right.add(new RightMethod("exact", true, points, 0, List.of(), List.of(), List.of()));
        List<Kill> kills = new ArrayList<>();
        for (Case one : exercise.cases())
            if (!one.name().equals(Breaking.SIZE)) kills.add(proving.kill(one.name()));
        return new Proof(exercise, seed, right, kills, Optional.empty(), Optional.empty());
    }

    private Kill kill(String name) {
        List<String> hazards =
                samples.stream()
                        .filter(sample -> isBroken(name, sample))
                        .map(Sample::hazard)
                        .limit(1)
                        .toList();
        boolean mutant = topic.mutants().stream().anyMatch(one -> one.name().equals(name));
        return new Kill(name, mutant, true, hazards, hazards, List.of(), true);
    }

    private boolean isBroken(String name, Sample sample) {
        MethodsOnInput<?, ?, ?> methods = methods(exercise.topic(), sample.json());
        return methods.faulty(Set.of(name)).get(0).failed()
                && methods.right().stream().noneMatch(MethodResult::failed);
    }

    private static MethodsOnInput<?, ?, ?> methods(String topic, String json) {
        return MethodsOnInput.of(topic, Phrase.of("break.input"), json);
    }

    /** The samples of a topic, hazards that are there for mutants first, and short ones first. */
    private static <C, I, O> List<Sample> samples(Topic<C, I, O> topic) {
        Set<String> forMutants = new HashSet<>();
        for (Mutant<C> one : topic.mutants()) forMutants.add(one.hazard());
        List<Sample> samples = new ArrayList<>();
        for (Hazard<I> one : topic.hazards())
            for (I single : topic.format().singles(one.input()))
                handed(topic, single)
                        .map(json -> new Sample(one.name(), json, forMutants.contains(one.name())))
                        .ifPresent(samples::add);
        samples.sort(
                Comparator.comparing((Sample one) -> !one.forMutants())
                        .thenComparing(one -> one.json().length()));
        return samples;
    }

    /**
     * The input as JSON; empty where it cannot be told outside, is too long, or is refused as one.
     */
    private static <C, I, O> Optional<String> handed(Topic<C, I, O> topic, I input) {
        String json;
        try {
            json = InputJson.of(topic.format(), input);
        } catch (IllegalArgumentException notTold) {
            return Optional.empty();
        }
        if (json.length() > HandedInputs.MOST_CHARACTERS) return Optional.empty();
        try {
            methods(topic.name(), json);
            return Optional.of(json);
        } catch (CatalogueException refused) {
            return Optional.empty();
        }
    }
}
