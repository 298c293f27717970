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
import rasterlab.engine.study.Mutant;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.proving.Marked;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.topic.TopicGradings;

/** Properties hold for all right methods, and break for wrong ones. */
class PropertiesTest {
    private static final int SEEDS = 5;

    static Stream<Exercise> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.cases().stream().anyMatch(each -> each.property().isPresent()));
    }

    /** The properties of an exercise, on inputs that the seed draws. */
    private static List<Case> properties(Exercise exercise) {
        return exercise.cases().stream()
                .filter(one -> one.property().isPresent())
                .map(
                        one ->
                                new Case(
                                        one.name(),
                                        one.title(),
                                        one.group(),
                                        one.kind(),
                                        Disclosure.NEVER,
                                        one.points(),
                                        one.input().replaceFirst("\"seed\":\\d+,?", ""),
                                        true,
                                        one.property()))
                .toList();
    }

    private static List<String> broken(Exercise exercise, Object method, long seed) {
        List<Case> cases = properties(exercise);
        return Marked.on(exercise, cases, TopicGradings.of(exercise), method, seed).breaking();
    }

    @ParameterizedTest(name = "a right method of {0} breaks a property")
    @MethodSource("exercises")
    void everyRightMethodKeepsThem(Exercise exercise) {
        for (Method<?> method : Topics.named(exercise.topic()).methods()) {
            boolean right =
                    exercise.tolerance()
                            .truth()
                            .map(method.name()::equals)
                            .orElse(method.promisesToBeRight());
            for (long seed = 1; right && seed <= SEEDS; seed++)
                assertEquals(
                        List.of(),
                        broken(exercise, method.implementation(), seed),
                        method.name() + ", seed " + seed);
        }
    }

    /** The exercises but for lines, which have mutants of their own, as each case there has. */
    static Stream<Exercise> withoutLines() {
        return exercises().filter(one -> !one.topic().equals("line"));
    }

    @ParameterizedTest(name = "nothing breaks a property of {0}")
    @MethodSource("withoutLines")
    void eachIsBrokenByAFaultyMethod(Exercise exercise) {
        var topic = Topics.named(exercise.topic());
        List<String> names =
                Stream.of(
                                topic.methods().stream()
                                        .filter(Method::faulty)
                                        .map(Method::implementation),
                                topic.mutants().stream().map(Mutant::implementation),
                                FaultyMethods.of(topic.name()).stream())
                        .flatMap(some -> some)
                        .flatMap(one -> broken(exercise, one, 1).stream())
                        .toList();
        for (Case one : properties(exercise)) assertTrue(names.contains(one.name()), one.name());
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
