package rasterlab.exercises.property;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.proving.TriedMethod;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.topic.TopicGradings;

class PropertiesTest {
    private static final int SEEDS = 5;

    static Stream<Exercise> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.cases().stream().anyMatch(each -> each.property().isPresent()));
    }

    /** The exercise with its properties alone. */
    private static List<String> broken(Exercise exercise, Object method, long seed) {
        return TriedMethod.on(
                        exercise,
                        exercise.cases().stream()
                                .filter(one -> one.property().isPresent())
                                .toList(),
                        TopicGradings.of(exercise),
                        method,
                        seed)
                .breaking();
    }

    @ParameterizedTest(name = "a right method of {0} breaks a property")
    @MethodSource("exercises")
    void everyRightMethodKeepsThem(Exercise exercise) {
        for (Method<?> method : Topics.named(exercise.topic()).methods())
            if (method.promisesToBeRight() && exercise.tolerance().truth().isEmpty())
                for (long seed = 1; seed <= SEEDS; seed++)
                    assertEquals(
                            List.of(),
                            broken(exercise, method.implementation(), seed),
                            method.name() + ", seed " + seed);
    }

    /** Those of lines have mutants of their own, as each case there has. */
    static Stream<Exercise> withoutLines() {
        return exercises().filter(one -> !one.topic().equals("line"));
    }

    @ParameterizedTest(name = "nothing breaks a property of {0}", allowZeroInvocations = true)
    @MethodSource("withoutLines")
    void eachIsBrokenByAFaultyMethodOrMutant(Exercise exercise) {
        var topic = Topics.named(exercise.topic());
        List<String> names =
                Stream.concat(
                                topic.methods().stream()
                                        .filter(Method::faulty)
                                        .map(one -> (Object) one.implementation()),
                                topic.mutants().stream().map(one -> one.implementation()))
                        .flatMap(one -> broken(exercise, one, 1).stream())
                        .toList();
        for (Case one : exercise.cases())
            if (one.property().isPresent()) assertTrue(names.contains(one.name()), one.name());
    }

    @Test
    void eachIsNamedAndTellsItsRuleInBothLanguages() {
        for (Property<?, ?> one : Properties.all())
            for (Message said : List.of(one.broken(), one.held(3), one.rule())) {
                String text = said.in("en");
                assertTrue(!text.contains("property."), text);
                assertTrue(
                        said.in("ru").matches(".*[а-яё].*")
                                && !said.in("ru").contains("property."));
            }
    }
}
