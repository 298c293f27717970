package rasterlab.exercises.topic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.topic.CaseRules.CaseRule;

/** Tests that a verdict is told with how exactly an answer is compared and by which rule. */
class CaseRulesTest {
    private static final Catalogue CATALOGUE = Catalogue.builtIn();

    static Stream<String> exercises() {
        return CATALOGUE.all().stream().map(Exercise::id);
    }

    @ParameterizedTest(name = "a case of {0} has no tolerance, or one without a text")
    @MethodSource("exercises")
    void everyCaseIsComparedInSomeWay(String id) {
        Exercise exercise = CATALOGUE.named(id);
        for (Exercise.Case one : exercise.cases()) {
            CaseRule right = CaseRules.of(exercise, one.name()).orElseThrow();
            assertTrue(right.tolerance().in("en").matches("(to within|exactly).*"), id);
            assertTrue(right.tolerance().in("ru").matches("(с точностью|точно).*"), id);
            assertFalse(right.tolerance().in("en").contains("bound."), id);
            if (exercise.form() == TaskKind.WRITE) {
                assertFalse(right.rule().isEmpty(), id + " has no rule");
                assertTrue(right.rule().in("ru").matches(".*[а-яё].*"), right.rule().in("ru"));
            }
        }
    }

    @ParameterizedTest(name = "{1} of {0} is compared otherwise")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            shade-face       | to within 0.01 levels of 255               | с точностью до 0,01 уровня из 255
            clip-segment     | to within 1·10⁻⁹ of the window's size      | с точностью до 1·10⁻⁹ размера окна
            circle           | exactly                                    | точно
            point-in-polygon | exactly                                    | точно
            flatten-curve    | to within the given flatness in pixels     | с точностью до заданной плоскостности в пикселях
            hermite          | to within 2⁻³⁰ of the largest coordinate   | с точностью до 2⁻³⁰ наибольшей координаты
            predict-curve    | to within 0.02 units of the coordinates    | с точностью до 0,02 единицы координат
            """)
    void theToleranceIsTheExercises(String id, String english, String russian) {
        Exercise exercise = CATALOGUE.named(id);
        String open = exercise.cases().get(0).name();
        CaseRule right = CaseRules.of(exercise, open).orElseThrow();
        assertEquals(english, right.tolerance().in("en"));
        assertEquals(russian, right.tolerance().in("ru"));
    }

    @Test
    void aCaseThatAllowsLessIsToldSo() {
        Exercise exercise = CATALOGUE.named("line-bresenham");
        boolean either = false;
        boolean strict = false;
        for (Exercise.Case one : exercise.cases()) {
            String rule = CaseRules.of(exercise, one.name()).orElseThrow().rule().in("en");
            boolean asksForOne = one.input().contains("\"strict\":true");
            assertEquals(asksForOne, rule.contains("the smaller coordinate"), one.name());
            assertEquals(!asksForOne, rule.contains("either is right"), one.name());
            strict |= asksForOne;
            either |= !asksForOne;
        }
        assertTrue(either && strict);
    }

    @ParameterizedTest(name = "a faulty method of {0} fails beyond another bound")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            break-clip-segment  | to within 1·10⁻¹² of the window's size
            break-polygon-fill  | exactly
            break-depth-order   | to within 1·10⁻⁷ % of what is covered
            predict-line        | exactly
            predict-depth-triangle | to within 0.001 of the depth, which goes from 0 to 1
            """)
    void whatIsNotWrittenIsComparedByTheTopic(String id, String told) {
        Exercise exercise = CATALOGUE.named(id);
        String first = exercise.cases().get(0).name();
        assertEquals(told, CaseRules.of(exercise, first).orElseThrow().tolerance().in("en"));
    }

    @Test
    void aLineThatIsNoCaseIsNotCompared() {
        assertEquals(Optional.empty(), CaseRules.of(CATALOGUE.named("circle"), "speed"));
    }
}
