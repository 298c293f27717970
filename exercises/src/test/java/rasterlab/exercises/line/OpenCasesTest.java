package rasterlab.exercises.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;

/** The report on open cases is the same whether hidden cases are tried beside them or not. */
@Tag("slow")
class OpenCasesTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");

    @ParameterizedTest(name = "{0}")
    @MethodSource("rasterlab.exercises.line.LineMutants#all")
    void hiddenCasesChangeNothingThatIsSaidOfOpenOnes(String name, LineRasterizer method) {
        assertEquals(alone(method), among(method, 1), name);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 4})
    @DisplayName("a last pixel that only hidden lines show alone is forgiven on open lines")
    void aMistakeThatHiddenCasesMeetAloneIsStillToldOnOpenOnes(long seed) {
        assertEquals(alone(OpenCasesTest::cutShort), among(OpenCasesTest::cutShort, seed));
    }

    /**
     * Draws wrong in several ways at once, so that it depends on the line which of them is told.
     */
    private static void cutShort(int x0, int y0, int x1, int y1, Pixels out) {
        for (int x = x0; x < x1; x++) out.plot(x, y0 + (y1 - y0) * (x - x0) / (x1 - x0));
    }

    @Test
    @DisplayName("a table of the open cases is told that they are wrong")
    void pointsOfATableOfTheOpenCasesAreWithheldApart() {
        LineRasterizer table = table();
        assertEquals(alone(table), among(table, 1));
        MarkedMethod marked = MarkedMethod.of(EXERCISE, table, CaseSelection.all(1));
        List<Case> withheld = marked.marking().withheld();
        assertTrue(withheld.size() > 10, withheld::toString);
        int right =
                marked.marking().reports().stream().mapToInt(CaseReport::points).sum()
                        - withheld.stream().mapToInt(Case::points).sum();
        assertEquals(marked.points(), right);
        MarkedMethod open = MarkedMethod.of(EXERCISE, table, CaseSelection.open());
        assertEquals(List.of(), open.failed(openCases().toList()));
    }

    private static LineRasterizer table() {
        List<Segment> open = new ArrayList<>();
        openCases().forEach(one -> open.addAll(TriedSegments.of(EXERCISE, one, 0)));
        return (x0, y0, x1, y1, out) -> {
            if (open.contains(new Segment(x0, y0, x1, y1)))
                new BresenhamLine().draw(x0, y0, x1, y1, out);
        };
    }

    private static Stream<Case> openCases() {
        return EXERCISE.cases().stream().filter(one -> one.visibility() == Disclosure.OPEN);
    }

    private static List<String> alone(LineRasterizer method) {
        return messages(MarkedMethod.of(EXERCISE, method, CaseSelection.open()));
    }

    private static List<String> among(LineRasterizer method, long seed) {
        return messages(MarkedMethod.of(EXERCISE, method, CaseSelection.all(seed)));
    }

    private static List<String> messages(MarkedMethod marked) {
        return marked.marking().reports().stream()
                .filter(one -> one.visibility() == Disclosure.OPEN)
                .map(
                        one ->
                                "%s: %s, %d of %d, %s, %s"
                                        .formatted(
                                                one.name(),
                                                one.verdict(),
                                                one.points(),
                                                one.of(),
                                                one.message(),
                                                one.place()))
                .toList();
    }
}
