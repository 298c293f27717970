package rasterlab.exercises.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.Disclosure;

/** One mistake costs about one mistake, and what is no solution costs nearly everything. */
@Tag("slow")
class FairMarkingTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");
    private static final LineRasterizer RIGHT = new BresenhamLine();
    private static final long[] SEEDS = {0, 1, 42, -7, Long.MAX_VALUE};

    /** The points for accuracy and stability; speed is not marked here. */
    private static final int ALL = EXERCISE.points().accuracy() + EXERCISE.points().stability();

    private static MarkedMethod marked(LineRasterizer method, long seed) {
        return MarkedMethod.of(EXERCISE, method, CaseSelection.all(seed));
    }

    @Test
    @DisplayName("an exact line without its last pixel fails every case")
    void aMissingLastPixelCostsTheCasesNamedAfterIt() {
        for (long seed : SEEDS)
            assertEquals(
                    Set.of(
                            "last-pixel-is-dropped",
                            "last-pixel-anywhere",
                            "single-point-is-skipped",
                            "points"),
                    Set.copyOf(marked(LineMutants.known("last-pixel-left-out"), seed).failed()),
                    "seed " + seed);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("sharedMistakes")
    void aMistakeOnEveryLineIsPaidOnceAndNamed(String said, LineRasterizer method) {
        for (long seed : SEEDS) {
            MarkedMethod marked = marked(method, seed);
            int lost = ALL - marked.points();
            assertTrue(lost >= 4 && lost <= 13, () -> lost + " lost by " + marked.failed());
            assertTrue(marked.shared().contains(said), marked::shared);
            assertTrue(marked.shared().contains("for example on the line from ("), marked::shared);
        }
    }

    static Stream<Arguments> sharedMistakes() {
        return Stream.of(
                mistake("the last pixel is missing", LineMutants.known("last-pixel-left-out")),
                mistake("the first pixel is missing", LineMutants.known("first-pixel-left-out")),
                mistake(
                        "the pixels come in reverse order",
                        (x0, y0, x1, y1, out) -> RIGHT.draw(x1, y1, x0, y0, out)),
                mistake(
                        "ties go to the larger coordinate",
                        LineMutants.known("ties-to-the-larger")),
                mistake("the line is shifted by 0 in x and +1 in y", LineMutants::shifted),
                mistake(
                        "x and y are exchanged",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(y, x))),
                mistake(
                        "left and right are exchanged",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(2 * x0 - x, y))),
                mistake(
                        "left and right are exchanged",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(-x, y))),
                mistake(
                        "up and down are exchanged",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(x, -y))),
                mistake(
                        "up and down are exchanged. This shows only on lines upwards",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(
                                        x0,
                                        y0,
                                        x1,
                                        y1,
                                        (x, y) -> out.plot(x, y1 < y0 ? 2 * y0 - y : y))),
                mistake(
                        "reverse order, from the last end to the first. This shows only on lines to the left",
                        LineMutants.known("always-from-the-left")));
    }

    private static Arguments mistake(String said, LineRasterizer method) {
        return argumentSet(said, said, method);
    }

    @Test
    @DisplayName("a title says that the ends matter, where it is the ties that do")
    void casesOnTiesAskForTheSmallerCoordinate() {
        List<Case> failed = cases(marked(LineMutants.known("ties-to-the-larger"), 1).failed());
        for (Case one : failed) {
            assertTrue(one.title("en").contains("to the smaller coordinate"), one.title("en"));
            assertTrue(one.title("ru").contains("меньшая координата"), one.title("ru"));
        }
        assertTrue(failed.size() > 1, failed::toString);
    }

    private static List<Case> cases(List<String> names) {
        return EXERCISE.cases().stream().filter(one -> names.contains(one.name())).toList();
    }

    @Test
    @DisplayName("a mistake at ties costs other points than the statement says")
    void theStatementSaysWhatTiesCost() {
        int lost = ALL - marked(LineMutants.known("ties-to-the-larger"), 1).points();
        String english = EXERCISE.statement().get("en");
        String russian = EXERCISE.statement().get("ru");
        assertTrue(english.contains("one at ties " + lost + "."), english);
        assertTrue(russian.contains("при равенстве\u00a0— " + lost + "."), russian);
    }

    @Test
    @DisplayName("what all failures share is a chain of semicolons")
    void theSharedMistakeIsReadAsSentences() {
        MarkedMethod marked =
                marked(
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(y, x)),
                        1);
        assertEquals(
                "One mistake explains all that is wrong – x and y are exchanged. This shows on"
                        + " every line, for example on the line from (0, 0) to (7, 3).",
                marked.shared());
    }

    @Test
    @DisplayName("two mistakes cost more than both, or are not told apart")
    void twoMistakesCostBoth() {
        LineRasterizer withoutLast = LineMutants.known("last-pixel-left-out");
        LineRasterizer both = (x0, y0, x1, y1, out) -> withoutLast.draw(x1, y1, x0, y0, out);
        MarkedMethod marked = marked(both, 1);
        int lost = ALL - marked.points();
        assertTrue(lost >= 11 && lost <= 16, () -> lost + " lost by " + marked.failed());
    }

    @Test
    @DisplayName("gaps on steep lines fail the cases on gentle ones, or on the last pixel")
    void steepGapsCostTheSteepCases() {
        List<String> failed = marked(LineMutants.known("one-pixel-a-column"), 3).failed();
        assertTrue(failed.contains("steep-line-leaves-gaps"), failed::toString);
        assertTrue(failed.contains("octant-2"), failed::toString);
        for (String other : List.of("last-pixel-anywhere", "octant-1", "order-anywhere"))
            assertTrue(!failed.contains(other), () -> other + " is in " + failed);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("noSolutions")
    void whatIsNoSolutionEarnsAtMostTen(LineRasterizer method) {
        for (long seed : SEEDS) {
            MarkedMethod marked = marked(method, seed);
            assertTrue(marked.points() <= 10, () -> marked.points() + ", fails " + marked.failed());
        }
    }

    static Stream<Arguments> noSolutions() {
        return Stream.of(
                argumentSet("an empty method", none((x0, y0, x1, y1, out) -> {})),
                argumentSet("a constant refusal", none(FairMarkingTest::refuse)),
                argumentSet(
                        "the first pixel alone", none((x0, y0, x1, y1, out) -> out.plot(x0, y0))),
                argumentSet(
                        "both ends alone",
                        none(
                                (x0, y0, x1, y1, out) -> {
                                    out.plot(x0, y0);
                                    if (x0 != x1 || y0 != y1) out.plot(x1, y1);
                                })),
                argumentSet("a table of the open cases", none(table((a, b, c, d, out) -> {}))),
                argumentSet(
                        "a table of the open cases that refuses all others",
                        none(table(FairMarkingTest::refuse))));
    }

    private static LineRasterizer none(LineRasterizer method) {
        return method;
    }

    private static void refuse(int x0, int y0, int x1, int y1, Object out) {
        throw new IllegalArgumentException("no");
    }

    private static LineRasterizer table(LineRasterizer otherwise) {
        List<Segment> open =
                EXERCISE.cases().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .flatMap(one -> TriedSegments.of(EXERCISE, one, 0).stream())
                        .toList();
        return (x0, y0, x1, y1, out) -> {
            boolean known = open.contains(new Segment(x0, y0, x1, y1));
            (known ? RIGHT : otherwise).draw(x0, y0, x1, y1, out);
        };
    }

    @Test
    @DisplayName("a public line to the right is lost with the hidden ones to the left")
    void aMistakeOnLinesToTheLeftCostsNoLineToTheRight() {
        LineRasterizer leftThrows =
                (x0, y0, x1, y1, out) -> {
                    if (x1 < x0) throw new ArithmeticException("left");
                    RIGHT.draw(x0, y0, x1, y1, out);
                };
        for (long seed : SEEDS) {
            MarkedMethod marked = marked(leftThrows, seed);
            List<String> failed = marked.failed();
            for (Case one : EXERCISE.cases())
                if (one.visibility() == Disclosure.OPEN
                        && TriedSegments.of(EXERCISE, one, 0).stream()
                                .allMatch(segment -> segment.x1() >= segment.x0()))
                    assertTrue(!failed.contains(one.name()), () -> one.name() + " in " + failed);
            String shared =
                    "it throws java.lang.ArithmeticException. This shows only on lines to the left";
            assertTrue(marked.shared().contains(shared), marked::shared);
        }
    }

    @Test
    @DisplayName("speed is held against a method that is wrong")
    void theReferenceForSpeedIsRight() {
        for (long seed : SEEDS)
            assertEquals(List.of(), marked(new PlainBresenham(), seed).failed());
    }

    @Test
    @DisplayName("a refusal is worth nothing though all other lines are right")
    void aRefusalPaysWhereTheOtherLinesOfItsKindAreRight() {
        LineRasterizer careful =
                (x0, y0, x1, y1, out) -> {
                    if (Math.max(Math.abs((long) x1), Math.abs((long) x0)) > 1 << 30)
                        throw new IllegalArgumentException("too far");
                    RIGHT.draw(x0, y0, x1, y1, out);
                };
        assertEquals(ALL, marked(careful, 5).points(), marked(careful, 5).failed()::toString);
    }

    @Test
    @DisplayName("open cases are worth most of the accuracy")
    void generatedHiddenCasesCarryThreeFifthsOfTheAccuracy() {
        int generated =
                EXERCISE.cases().stream()
                        .filter(one -> one.kind() == Criterion.ACCURACY && one.generated())
                        .mapToInt(Case::points)
                        .sum();
        assertTrue(generated >= 0.6 * EXERCISE.points().accuracy(), () -> generated + " points");
    }

    @Test
    @DisplayName("pixels out of order pass in cases on something else, where nothing pays for it")
    void theOrderIsCheckedInEveryCase() {
        LineRasterizer outOfOrderDownwards =
                (x0, y0, x1, y1, out) -> {
                    boolean special = x0 == 0 && y0 == 0 && x1 == 2 && y1 == 9;
                    if (special) RIGHT.draw(x1, y1, x0, y0, out);
                    else RIGHT.draw(x0, y0, x1, y1, out);
                };
        assertEquals(List.of("steep-line-leaves-gaps"), marked(outOfOrderDownwards, 2).failed());
    }
}
