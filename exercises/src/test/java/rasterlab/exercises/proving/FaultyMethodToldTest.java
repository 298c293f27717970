package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.topic.TopicGradings;

/** A faulty method's name means nothing to a student who has not read it. */
class FaultyMethodToldTest {
    private static final long SEED = 20261127;

    /**
     * The visible fault of a method is told first: its other faults need a radius that few cases
     * have.
     */
    @ParameterizedTest(name = "the name alone stands for a mistake: {0}")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            en | One mistake explains all that is wrong – pixels on axes and diagonals are plotted twice, that of radius 0 eight times | (bresenham-textbook answers the same)
            ru | Всё неверное объясняет одна ошибка — пиксели на осях и диагоналях выводятся дважды, пиксель радиуса 0\u00a0— восемь раз | (так же отвечает bresenham-textbook)
            """)
    void aMethodsFaultsAreToldWithItsName(String language, String faults, String name) {
        String said = marking("circle", "bresenham-textbook").shared().in(language);
        assertTrue(said.startsWith(faults), said);
        assertTrue(said.contains(name), said);
    }

    @ParameterizedTest(name = "long faults are told in full, or cut within one: {0}")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            faults.clip-segment.cohen-sutherland-nested-textbook | endless for an end only below, only right or only left (x answers the same)
            faults.line.bresenham-first-textbook                 | gaps above 45°, one pixel to the left, never falls; overflow from 2³⁰ on, endless up to the largest int (x answers the same)
            """)
    void theFirstOfManyFaultsAreTold(String key, String told) {
        assertEquals(told, Message.of("known-answer.told", "x", key).in("en"));
    }

    @Test
    void aCaseThatAsksForAMethodsFaultIsTitledByIt() {
        Exercise circle = Catalogue.builtIn().named("break-circle");
        Case textbook =
                circle.cases().stream()
                        .filter(one -> one.name().equals("bresenham-textbook"))
                        .findFirst()
                        .orElseThrow();
        assertEquals(
                "to show: pixels on axes and diagonals are plotted twice (bresenham-textbook)",
                textbook.title("en"));
        assertEquals(
                "показать: пиксели на осях и диагоналях выводятся дважды (bresenham-textbook)",
                textbook.title("ru"));
    }

    @Test
    void noTitleIsAnIdentifier() {
        assertAll(
                Catalogue.builtIn().all().stream()
                        .filter(one -> one.form() == TaskKind.BREAK)
                        .flatMap(one -> one.cases().stream())
                        .flatMap(one -> List.of(one.title("en"), one.title("ru")).stream())
                        .map(
                                title ->
                                        () -> {
                                            assertFalse(
                                                    title.matches("\\S+( \\S+)?: [a-z0-9-]+"),
                                                    title);
                                            assertTrue(title.length() <= 140, title);
                                        }));
    }

    @Test
    void aSentenceOnTheCounterexampleIsNotToldTwice() {
        List<Message> told =
                marking("line-bresenham", "bresenham-textbook").reports().stream()
                        .map(one -> one.explanation())
                        .filter(said -> said.in("en").startsWith("broken property"))
                        .toList();
        assertFalse(told.isEmpty());
        for (Message said : told)
            assertEquals(
                    said.sentences().size(),
                    said.sentences().stream().distinct().count(),
                    said.in("en"));
    }

    private static Marking marking(String id, String method) {
        Exercise exercise = Catalogue.builtIn().named(id);
        var calls = GradedMethod.calls(exercise, TopicGradings.of(exercise), SEED);
        Object faulty = Topics.named(exercise.topic()).method(method).implementation();
        return GradedMethod.on(exercise, calls, faulty).marking;
    }
}
