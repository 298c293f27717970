package rasterlab.exercises.breaking;

import static java.util.stream.Collectors.toSet;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Mutant;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.proving.Proving;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Phrase;

/** Every exercise that asks for inputs can be solved. */
class BreakExercisesTest {
    /** Points of 100 for mistakes; those for small inputs make them one more. */
    private static final int MOST_OF_A_STARTER = 9;

    static List<Exercise> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == TaskKind.BREAK)
                .toList();
    }

    @Test
    void thereIsOneForAlmostEveryTopicWithFaultyMethods() {
        assertTrue(exercises().size() >= 14, exercises().size() + " exercises");
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void eachFaultyMethodFailsOnAnInputOnWhichTheRightOnesAgree(Exercise exercise) {
        Proof proof = Proving.of(exercise, 0);
        assertEquals(exercise.cases().size() - 1, proof.kills().size());
        assertEquals(List.of(), proof.faults().stream().map(one -> one.in("en")).toList());
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void theStarterIsAnInputThatShowsLittle(Exercise exercise) {
        HandedInputs handed = HandedInputs.of(exercise.topic(), exercise.starter(), 1);
        var methods =
                MethodsOnInput.of(
                        exercise.topic(), Phrase.quoted("starter"), handed.inputs().get(0));
        assertTrue(methods.right().stream().noneMatch(MethodResult::failed), "right ones agree");
        Set<String> names = Set.copyOf(exercise.cases().stream().map(Case::name).toList());
        List<MethodResult> faulty = methods.faulty(names);
        assertFalse(faulty.isEmpty());
        Set<String> broken =
                faulty.stream()
                        .filter(MethodResult::failed)
                        .map(MethodResult::method)
                        .collect(toSet());
        int earned =
                exercise.cases().stream()
                        .filter(one -> broken.contains(one.name()))
                        .mapToInt(Case::points)
                        .sum();
        assertTrue(earned <= MOST_OF_A_STARTER, () -> earned + " points for " + broken);
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void theFormAndTheNumberOfProgramsAreTold(Exercise exercise) {
        int programs = exercise.cases().size() - 1;
        for (String language : List.of("en", "ru")) {
            String statement = exercise.statement(language);
            assertTrue(statement.contains(String.valueOf(programs)), language);
            assertTrue(
                    Stream.of("`./lab run " + exercise.topic() + "`").allMatch(statement::contains),
                    language);
        }
        assertEquals(100, exercise.points().total());
        assertEquals(100, exercise.cases().stream().mapToInt(Case::points).sum());
    }

    /** An example that counts pixels is what the report says, whose order counts nowhere. */
    @ParameterizedTest
    @ValueSource(strings = {"circle", "ellipse", "line", "polygon-fill"})
    void theExampleOfPixelsIsWhatAReportSays(String topic) {
        Exercise exercise = Catalogue.builtIn().named("break-" + topic);
        String english = exercise.statement("en");
        Matcher example =
                Pattern.compile("(?:mistake “([^”]+)”|method `(.+)`) is\\s+given\\s+(\\{.*\\})")
                        .matcher(english);
        assertTrue(example.find());
        String method =
                Topics.named(topic).mutants().stream()
                        .map(Mutant::name)
                        .filter(one -> isSaid(topic, one, example.group(1)))
                        .findFirst()
                        .orElse(example.group(2));
        Message said =
                MethodsOnInput.of(topic, Phrase.quoted("example"), example.group(3))
                        .faulty(Set.of(method))
                        .get(0)
                        .message();
        for (String language : List.of("en", "ru")) {
            String statement = exercise.statement(language).replaceAll("\\s+", " ");
            String told = ": " + said.in(language) + ".";
            assertTrue(statement.contains(told), () -> "says not" + told);
        }
    }

    private static boolean isSaid(String topic, String mutant, String words) {
        String text = Message.of("mutant." + topic + "." + mutant).in("en");
        return words != null && text.equals(words.replaceAll("\\s+", " "));
    }
}
