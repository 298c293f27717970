package rasterlab.exercises.breaking;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Breaking;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.json.JsonSink;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.judging.MethodsOnInput.Tried;
import rasterlab.exercises.score.Phrase;

/** Every exercise that asks for inputs can be solved. */
class BreakExercisesTest {
    private static final JsonMapper MAPPER = new JsonMapper();

    /** What is handed in at the start must not solve half of it. */
    private static final double MOST_OF_A_STARTER = 0.5;

    static List<Exercise> exercises() {
        return Catalogue.builtIn().all().stream().filter(one -> one.form() == Form.BREAK).toList();
    }

    @Test
    void thereIsOneForAlmostEveryTopicWithFaultyMethods() {
        assertTrue(exercises().size() >= 14, exercises().size() + " exercises");
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void eachFaultyMethodFailsOnAnInputOnWhichTheRightOnesAgree(Exercise exercise)
            throws IOException {
        List<String> inputs = inputs(Topics.named(exercise.topic()));
        List<String> unbroken = new ArrayList<>();
        for (Case one : exercise.cases())
            if (!one.name().equals(Breaking.SIZE) && !isBroken(exercise, one.name(), inputs))
                unbroken.add(one.name());
        assertEquals(List.of(), unbroken);
    }

    private static boolean isBroken(Exercise exercise, String name, List<String> inputs) {
        return inputs.stream()
                .map(input -> MethodsOnInput.of(exercise.topic(), Phrase.quoted("input"), input))
                .anyMatch(
                        methods ->
                                methods.faulty(Set.of(name)).get(0).failed()
                                        && methods.right().stream().noneMatch(Tried::failed));
    }

    /** Short ones first; those of hazards that are there for mutants before all others. */
    private static <C, I, O> List<String> inputs(Topic<C, I, O> topic) throws IOException {
        Set<String> forMutants =
                Set.copyOf(topic.mutants().stream().map(Mutant::hazard).distinct().toList());
        List<I> all = new ArrayList<>();
        for (Hazard<I> one : topic.hazards())
            if (forMutants.contains(one.name())) all.add(one.input());
        for (Hazard<I> one : topic.hazards())
            if (!forMutants.contains(one.name())) all.add(one.input());
        List<String> inputs = new ArrayList<>();
        for (I one : all)
            for (I single : topic.format().singles(one)) inputs.addAll(json(topic, single));
        return inputs.stream()
                .filter(one -> one.length() <= HandedInputs.MOST_CHARACTERS)
                .sorted((a, b) -> Integer.compare(a.length(), b.length()))
                .toList();
    }

    /** None where the input cannot be told outside, or is refused as one. */
    private static <C, I, O> List<String> json(Topic<C, I, O> topic, I input) throws IOException {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = MAPPER.createGenerator(text)) {
            json.writeStartObject();
            topic.format().writeInput(input, new JsonSink(json));
            json.writeEndObject();
            json.flush();
            MethodsOnInput.of(topic.name(), Phrase.quoted("input"), text.toString());
            return List.of(text.toString());
        } catch (IllegalArgumentException refused) {
            return List.of();
        }
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void theStarterIsAnInputThatShowsLittle(Exercise exercise) {
        HandedInputs handed = HandedInputs.of(exercise.topic(), exercise.starter(), 1);
        var methods =
                MethodsOnInput.of(
                        exercise.topic(), Phrase.quoted("starter"), handed.inputs().get(0));
        assertTrue(methods.right().stream().noneMatch(Tried::failed), "right ones agree");
        Set<String> names = Set.copyOf(exercise.cases().stream().map(Case::name).toList());
        List<Tried> faulty = methods.faulty(names);
        long broken = faulty.stream().filter(Tried::failed).count();
        assertFalse(faulty.isEmpty());
        assertTrue(
                broken <= MOST_OF_A_STARTER * faulty.size(),
                () -> broken + " of " + faulty.size() + " are broken");
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
}
