package rasterlab.exercises.topic;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import rasterlab.engine.study.Guard;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.score.Message;

/**
 * Tells of each case of an exercise why it is there: what its inputs are, and which known mistakes
 * it catches. Of these it names the ones that the fewest other cases catch.
 */
public final class CaseReasons {
    /** Mistakes that are named. */
    private static final int MOST = 2;

    /** Draws the inputs that the mistakes are tried on: any will do. */
    private static final long SEED = 1;

    /** Wall time to try all mistakes on all cases; where it is not enough, none is named. */
    private static final Duration LIMIT = Duration.ofSeconds(10);

    private final Exercise exercise;

    /** Keys of the texts on the mistakes that each case catches, by its name. */
    private final Map<String, List<String>> caught;

    private final Map<String, Integer> catching = new HashMap<>();

    /**
     * Tries all mistakes on all cases, which takes a moment.
     *
     * @param exercise one for which students write a method
     */
    public CaseReasons(Exercise exercise) {
        this.exercise = exercise;
        var outcome = Guard.call("reasons of " + exercise.id(), () -> caught(exercise), LIMIT);
        caught =
                outcome instanceof Guard.Returned<Map<String, List<String>>> returned
                        ? returned.value()
                        : Map.of();
        for (List<String> mistakes : caught.values())
            for (String one : mistakes) catching.merge(one, 1, Integer::sum);
    }

    private static Map<String, List<String>> caught(Exercise exercise) {
        TopicGrading topic = TopicGradings.of(exercise);
        Map<String, List<String>> caught = new LinkedHashMap<>();
        for (Case one : exercise.cases())
            caught.put(
                    one.name(),
                    mistakes(exercise, topic, topic.calls(one, exercise.tolerance(), SEED)));
        return caught;
    }

    private static List<String> mistakes(
            Exercise exercise, TopicGrading topic, List<GradedCall> calls) {
        List<String> keys = new ArrayList<>();
        for (String mistake : new TreeSet<>(topic.mistakes())) {
            String key = "mutant." + topic.name() + "." + mistake;
            if (Message.isKnown(key)
                    && !exercise.evidence().notAsked().contains(mistake)
                    && !calls.stream().allMatch(call -> call.isRightWith(mistake))) keys.add(key);
        }
        return keys;
    }

    /** Why the case of that name is there; nothing where the exercise has none of it. */
    public Message of(String name) {
        return exercise.cases().stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .map(
                        one ->
                                CaseInputs.of(exercise.topic(), one)
                                        .and(asked(one))
                                        .and(mistakes(name)))
                .orElse(Message.NONE);
    }

    /** Tells what the case asks for where others have the same inputs; nothing where none has. */
    private Message asked(Case one) {
        boolean alone =
                exercise.cases().stream().filter(each -> each.input().equals(one.input())).count()
                        == 1;
        return alone
                ? Message.NONE
                : exercise.group(one)
                        .map(Exercise.CaseGroup::title)
                        .map(title -> Message.of("why.asked", title.get("en"), title.get("ru")))
                        .orElse(Message.NONE);
    }

    private Message mistakes(String name) {
        List<String> named =
                caught.getOrDefault(name, List.of()).stream()
                        .sorted(Comparator.comparing(catching::get))
                        .limit(MOST)
                        .toList();
        return switch (named.size()) {
            case 0 -> Message.NONE;
            case 1 -> Message.of("why.mistake", named.get(0));
            default -> Message.of("why.mistakes", named.get(0), named.get(1));
        };
    }
}
