package rasterlab.exercises.topic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Message;

/** Each hidden case has a sentence on why it is there, and the mistake in it is one it catches. */
class CaseReasonsTest {
    private static final Catalogue CATALOGUE = Catalogue.builtIn();

    static Stream<String> written() {
        return CATALOGUE.all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id);
    }

    @ParameterizedTest(name = "a hidden case of {0} has no reason, or one in English only")
    @MethodSource("written")
    void everyHiddenCaseHasAReason(String id) {
        Exercise exercise = CATALOGUE.named(id);
        var reasons = new CaseReasons(exercise);
        List<Exercise.Case> hidden =
                exercise.cases().stream()
                        .filter(one -> one.visibility() != Disclosure.OPEN)
                        .toList();
        assertFalse(hidden.isEmpty());
        int naming = 0;
        Set<String> told = new HashSet<>();
        for (Exercise.Case one : hidden) {
            Message why = reasons.of(one.name());
            assertTrue(why.in("ru").matches("[а-яё].*"), one.name() + ": " + why.in("ru"));
            assertFalse(why.in("ru").contains("mutant."), why.in("ru"));
            assertFalse(why.in("en").contains("[=") || why.in("en").contains(", ="), why.in("en"));
            if (why.sentences().size() > 1) naming++;
            for (String language : List.of("en", "ru"))
                assertTrue(told.add(why.in(language)), "told twice: " + why.in(language));
        }
        assertTrue(naming > 0, "no case names a mistake");
    }

    @ParameterizedTest(name = "the reason of {1} does not name its mistake")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            triangulate  | random-clockwise  | it draws its inputs anew
            triangulate  | small-units       | an area below an absolute ε counts as none
            polygon-fill | random-on-centres | (12 of the form polygon: 6 × [0..9, 0..7]; rule: evenodd; size: [12, 10])
            polygon-fill | random-rules      | polygon: 9 × [0..30, 0..20]; rule: nonzero
            polygon-fill | random-beyond-the-picture | it catches these mistakes: columns to the left of the picture are filled, too; the even-odd rule
            polygon-fill | no-area           | ordinary inputs do not show (2 of the form polygon: [[1, 1], [9, 9], [5, 5]]
            clip-segment | far-window        | its input is made for one difficulty: “Coordinates are large against the window
            line-bresenham | order-anywhere | it alone pays for this: pixels come in order, each once
            line-bresenham | octant-4       | (6 of the form x: −500..500; y: −500..500; a: 2..40; b: 0..a; from: [x, y]; to: [x − a, y + b])
            line-bresenham | random-ties    | a: 2..20; b: 0..a; c: 2·a; d: b − b mod 2 + 1; from: [x, y]; to: [x + c, y + d]
            depth-order    | random-slanted | a: 2..6; z: 24..34; polygons: [[[−a, −3, 4], [a, −3, 4]
            """)
    void caseNamesTheMistakeThatFewOthersCatch(String id, String name, String said) {
        String why = new CaseReasons(CATALOGUE.named(id)).of(name).in("en");
        assertTrue(why.contains(said), why);
    }

    @Test
    void aCaseThatIsNotThereHasNoReason() {
        assertEquals(Message.NONE, new CaseReasons(CATALOGUE.named("triangulate")).of("none"));
    }
}
