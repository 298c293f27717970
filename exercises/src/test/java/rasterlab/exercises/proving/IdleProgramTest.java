package rasterlab.exercises.proving;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.topic.TopicGradings;

/** A program that does nothing is told so, and no other mistake is invented for it. */
class IdleProgramTest {
    private static final Catalogue CATALOGUE = Catalogue.builtIn();

    /** Starters that do something, or return what is no answer. */
    private static final List<String> BUSY =
            List.of("flatten-curve", "line-bresenham", "visible-faces");

    static Stream<String> idle() {
        return CATALOGUE.all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id)
                .filter(id -> !BUSY.contains(id));
    }

    private static GradedMethod tried(String id, Object program) {
        Exercise exercise = CATALOGUE.named(id);
        List<Case> open =
                exercise.cases().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .toList();
        return Marked.on(exercise, open, TopicGradings.of(exercise), program, 1);
    }

    private static String readableText(GradedMethod tried, String language) {
        return tried.marking.reports().stream()
                .map(CaseReport::explanation)
                .map(said -> said.in(language))
                .collect(joining("\n"));
    }

    @ParameterizedTest(name = "the starter of {0} is told a mistake that it does not make")
    @MethodSource("idle")
    void aProgramThatDoesNothingIsToldNoOtherMistake(String id) throws Exception {
        GradedMethod tried = tried(id, CompiledProgram.of(CATALOGUE.named(id).starter()));
        List<Message.Sentence> shared = tried.marking.shared().sentences();
        assertEquals(id.equals("depth-triangle") ? 3 : 2, shared.size(), shared.toString());
        assertTrue(shared.get(1).key().startsWith("mistake.nothing-"), shared.toString());
        assertFalse(
                readableText(tried, "en").contains("the same comes out if"),
                readableText(tried, "en"));
        assertFalse(
                readableText(tried, "en").contains("answers the same"), readableText(tried, "en"));
        assertFalse(readableText(tried, "ru").contains("тот же ответ"), readableText(tried, "ru"));
    }

    @ParameterizedTest(name = "the starter of {0} is told otherwise what it does")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            polygon-fill     | One mistake explains all that is wrong – the program sends nothing.
            seed-fill        | One mistake explains all that is wrong – the program leaves what it is given as it is.
            triangulate      | One mistake explains all that is wrong – what the program returns is empty.
            color            | One mistake explains all that is wrong – the program answers nothing but zeros.
            point-in-polygon | One mistake explains all that is wrong – the program answers false to everything.
            """)
    void whatTheProgramDoesIsTold(String id, String said) throws Exception {
        GradedMethod tried = tried(id, CompiledProgram.of(CATALOGUE.named(id).starter()));
        assertEquals(said, tried.marking.shared().in("en"));
    }

    @ParameterizedTest(name = "{0}: an answer is compared where a refusal was asked for, {1}")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            spline-function | equal-knots | an IllegalArgumentException was to be thrown here: x[
            spline-function | equal-knots | здесь надо было выбросить IllegalArgumentException: x[
            """)
    void aRefusalThatWasAskedForIsTold(String id, String name, String said) throws Exception {
        GradedMethod tried = tried(id, CompiledProgram.of(CATALOGUE.named(id).starter()));
        Message told =
                tried.marking.reports().stream()
                        .filter(one -> one.name().equals(name))
                        .findFirst()
                        .orElseThrow()
                        .explanation();
        String language = said.startsWith("an ") ? "en" : "ru";
        assertTrue(told.in(language).startsWith(said), told.in(language));
    }

    @Test
    void aMethodThatSendsNothingOnSomeInputsKeepsItsMistake() {
        Object mutant =
                rasterlab.engine.Topics.named("clip-polygon").allMutants().stream()
                        .filter(one -> one.name().equals("inside-is-lost"))
                        .findFirst()
                        .orElseThrow()
                        .implementation();
        assertTrue(readableText(tried("clip-polygon", mutant), "en").contains("is left out"));
    }
}
