package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.topic.TopicGradings;

/** The report on a wrong answer can be read at a glance, whatever mistake it is. */
class MessageLengthTest {
    private static final long SEED = 20261127;

    /** Words of any message. */
    private static final int MOST = 160;

    /** Words of a message on a broken property. */
    private static final int MOST_ON_PROPERTIES = 60;

    /** Inputs of each case; more of them tell the same. */
    private static final int INPUTS = 1;

    static Stream<String> written() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id);
    }

    @ParameterizedTest(name = "a message of {0} is too long")
    @MethodSource("written")
    void everyMistakeIsToldInFewWords(String id) {
        Exercise exercise = Catalogue.builtIn().named(id);
        TopicGrading grading = TopicGradings.of(exercise);
        Topic<?, ?, ?> topic = Topics.named(exercise.topic());
        List<Object> wrong = new ArrayList<>();
        topic.allMutants().stream().map(Mutant::implementation).forEach(wrong::add);
        topic.methods().stream()
                .filter(Method::faulty)
                .map(Method::implementation)
                .forEach(wrong::add);
        Set<Object> toldOnce = new HashSet<>();
        for (Case one : exercise.cases())
            for (GradedCall call : few(grading.calls(one, exercise.tolerance(), SEED)))
                for (Object method : wrong) {
                    if (one.property().isEmpty() && toldOnce.contains(method)) continue;
                    Answer answer = GradedMethod.answer(call, method);
                    if (call.check(answer).right()) continue;
                    toldOnce.add(method);
                    requireShort(one, call.judge(answer).message(), call.breaksProperty(answer));
                }
        assertFalse(toldOnce.isEmpty(), "no mistake shows");
    }

    private static List<GradedCall> few(List<GradedCall> calls) {
        return calls.subList(0, Math.min(INPUTS, calls.size()));
    }

    private static void requireShort(Case one, Message said, boolean onProperty) {
        int most = onProperty ? MOST_ON_PROPERTIES : MOST;
        for (String language : List.of("en", "ru")) {
            String text = said.in(language);
            int words = text.split("\\s+").length;
            assertTrue(words <= most, () -> one.name() + ", " + words + " words: " + text);
        }
    }
}
