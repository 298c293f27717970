package rasterlab.exercises.catalogue;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Capped;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.StatedLimits;

class CapsCheckTest {
    private static final Catalogue BUILT_IN = Catalogue.builtIn();

    static Stream<String> written() {
        return BUILT_IN.all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id);
    }

    @ParameterizedTest(name = "{0} takes answers that are too short for a right one")
    @MethodSource("written")
    void fewerBytesThanARightAnswerHasAreRefused(String id) {
        String said = refusal(id, bytes(1));
        assertTrue(
                said.matches(
                        ".*exercise\\.json, field 'caps\\.bytes': the right answer of case "
                                + "[a-z0-9-]+ has [1-9]\\d* bytes, at most 1 are taken"),
                said);
        taken(id, bytes(StatedLimits.MOST_BYTES));
    }

    @Test
    @DisplayName("a right answer of one truth value is told to be longer or shorter than it is")
    void theLengthIsThatOfTheAnswerOnItsWay() {
        taken("point-in-triangle", bytes(2));
        String said = refusal("point-in-triangle", bytes(1));
        assertTrue(said.contains(" has 2 bytes, at most 1 are taken"), said);
    }

    @Test
    @DisplayName("a case of a line that is cut asks for the whole line")
    void anAnswerThatIsCutCountsAsFarAsItIsLookedAt() {
        taken("line-bresenham", bytes(8 * 65_536));
    }

    @Test
    @DisplayName("a limit of items is held against the bytes")
    void fewerItemsThanARightAnswerHasAreRefused() {
        StatedLimits nine =
                new StatedLimits(OptionalInt.of(9), OptionalInt.empty(), Optional.empty());
        String said = refusal("circle", nine);
        assertTrue(said.contains("field 'caps.items'"), said);
        assertTrue(said.endsWith("items, at most 9 are taken"), said);
    }

    @Test
    @DisplayName("an exercise that comes with the program states a limit below a right answer")
    void theProgramsOwnExercisesAreTaken() {
        for (Exercise one : BUILT_IN.all())
            assertDoesNotThrow(() -> CapsCheck.check(ExerciseFolder.onClassPath(one.id()), one));
    }

    @Test
    @DisplayName("the Russian sentence has other numbers")
    void theNumbersAreToldInRussian() {
        var refused = refused("point-in-triangle", bytes(1)).in("ru");
        assertTrue(refused.contains("2\u00a0байт, а принимается не более 1"), refused);
    }

    private static StatedLimits bytes(int most) {
        return new StatedLimits(OptionalInt.empty(), OptionalInt.of(most), Optional.empty());
    }

    private static String refusal(String id, StatedLimits caps) {
        CatalogueException refused = refused(id, caps);
        assertEquals(refused.getMessage(), refused.in("en"));
        return refused.getMessage();
    }

    private static CatalogueException refused(String id, StatedLimits caps) {
        return assertThrows(CatalogueException.class, () -> check(id, caps));
    }

    private static void taken(String id, StatedLimits caps) {
        assertDoesNotThrow(() -> check(id, caps));
    }

    private static void check(String id, StatedLimits caps) {
        CapsCheck.check(ExerciseFolder.onClassPath(id), Capped.with(BUILT_IN.named(id), caps));
    }
}
