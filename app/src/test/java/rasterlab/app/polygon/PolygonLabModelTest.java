package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.app.polygon.outcome.CutAnswer;
import rasterlab.app.polygon.outcome.InsideAnswer;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.contract.FillRule;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

@Tag("slow")
@Timeout(300)
class PolygonLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final PolygonLabModel model =
            new PolygonLabModel(new PolygonTopics(), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for the answers and hands them to the model. */
    private void settle() {
        thread.settle(model::settle);
    }

    private MethodOutcome outcome() {
        settle();
        return model.state().results().outcome();
    }

    private InsideFigure inside() {
        return (InsideFigure) model.state().choice().scene().figure();
    }

    private SeedFigure seed() {
        return (SeedFigure) model.state().choice().scene().figure();
    }

    @ParameterizedTest(name = "a mode opens without steps or with a failure: {0}")
    @EnumSource
    void opensWithStepsToLookAt(PolygonMode mode) {
        model.chooseMode(mode);
        MethodOutcome opened = outcome();
        assertEquals(MethodOutcome.MethodEnding.ENDED, opened.ending());
        assertTrue(opened.steps() > 1);
        assertTrue(model.state().finished());
        assertEquals(opened.steps() + 1, model.last());
    }

    @ParameterizedTest(name = "a mode opens on a method that a hazard breaks: {0}")
    @EnumSource
    void opensOnAMethodThatIsRight(PolygonMode mode) {
        model.chooseMode(mode);
        String method = model.state().choice().scene().method();
        for (Hazard<?> hazard : model.hazards(mode)) {
            Verdict.Kind kind = hazard.recorded().get(method);
            boolean none = hazard.recorded().values().stream().allMatch(kind::equals);
            boolean refused = kind == Verdict.Kind.REFUSED;
            assertTrue(
                    kind == Verdict.Kind.EXACT || none || refused,
                    method + " on " + hazard.name() + ": " + kind);
        }
    }

    @ParameterizedTest(name = "lab and recorded verdict differ: {0}")
    @EnumSource
    void everyHazardEndsAsItIsRecorded(PolygonMode mode) {
        for (Hazard<?> hazard : model.hazards(mode))
            for (String method : model.methods(mode)) {
                model.chooseMode(mode);
                model.chooseMethod(method);
                model.show(mode, hazard.name());
                assertEquals(
                        expected(hazard.recorded().get(method)),
                        outcomeText(outcome()),
                        hazard.name() + ", " + method);
            }
    }

    private static String expected(Verdict.Kind kind) {
        return switch (kind) {
            case EXACT -> "right";
            case DEGRADED, WRONG -> "wrong";
            case REFUSED, ENDLESS, CRASHED -> kind.name();
        };
    }

    private static String outcomeText(MethodOutcome outcome) {
        if (outcome.ending() != MethodOutcome.MethodEnding.ENDED) return outcome.ending().name();
        return outcome.isRight() ? "right" : "wrong";
    }

    @Test
    void dragIsOneChangeForUndo() {
        PolygonChoice before = model.state().choice();
        model.beginDrag();
        for (int x = 0; x < 9; x++) model.move(Grip.corner(1), x, 4);
        model.endDrag();
        assertEquals(new PolygonPoint(8, 4), inside().corners().get(1));
        model.history().undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void resetLeavesTheOtherModesAlone() {
        model.move(Grip.POINT, 3, 3);
        model.chooseMode(PolygonMode.SEED);
        model.move(Grip.SEED, 20, 3);
        model.reset();
        assertEquals(SeedFigure.first(), seed());
        model.chooseMode(PolygonMode.TRIANGLE);
        assertEquals(new PolygonPoint(3, 3), inside().points().get(0));
    }

    @Test
    void clickAddsACornerBetweenTheEndsOfTheNearestEdge() {
        model.chooseMode(PolygonMode.POLYGON);
        int corners = inside().corners().size();
        model.click(6.2, 6);
        assertEquals(corners + 1, inside().corners().size());
        assertEquals(new PolygonPoint(6.2, 6), inside().corners().get(5));
        model.select(Grip.corner(5));
        model.shrink();
        assertEquals(corners, inside().corners().size());
    }

    @Test
    void triangleKeepsItsThreeCorners() {
        model.select(Grip.corner(0));
        model.shrink();
        model.grow();
        model.click(5, 2);
        assertEquals(3, inside().corners().size());
        assertEquals(new PolygonPoint(5, 2), inside().points().get(0));
    }

    @Test
    void pointsOfWholeNumbersSnap() {
        model.inside(old -> old.withWhole(true));
        model.move(Grip.POINT, 3.4, 2.6);
        assertEquals(new PolygonPoint(3, 3), inside().points().get(0));
    }

    @Test
    void seedStaysInThePictureAndOnAPixel() {
        model.chooseMode(PolygonMode.SEED);
        model.move(Grip.SEED, -7, 3.3);
        assertEquals(new PolygonPoint(0, 3), seed().seed());
        model.move(Grip.SEED, 1e9, 1e9);
        assertEquals(new PolygonPoint(seed().width() - 1, seed().height() - 1), seed().seed());
    }

    @Test
    void wallIsPutUpAndTakenAwayAtThePen() {
        model.chooseMode(PolygonMode.SEED);
        model.move(Grip.PEN, 5, 2);
        model.grow();
        assertEquals(SeedFigure.WALL, seed().rows().get(2).charAt(5));
        model.shrink();
        assertEquals(SeedFigure.FREE, seed().rows().get(2).charAt(5));
        model.click(5.2, 1.8);
        assertEquals(SeedFigure.WALL, seed().rows().get(2).charAt(5));
        model.click(-3, 50);
        assertEquals(SeedFigure.WALL, seed().rows().get(2).charAt(5));
    }

    @Test
    void eightNeighboursLeakThroughTheDiagonalGap() {
        model.chooseMode(PolygonMode.SEED);
        model.chooseMethod("stack");
        long four = ((PixelAnswer) outcome().answer()).writes();
        model.seed(old -> old.withConnectivity(8));
        long eight = ((PixelAnswer) outcome().answer()).writes();
        assertTrue(eight > four + 50, four + " pixels, then " + eight);
        assertTrue(model.state().results().outcome().isRight());
    }

    @Test
    void fillRuleDecidesTheMiddleOfTheStar() {
        model.chooseMode(PolygonMode.FILL);
        long evenOdd = ((PixelAnswer) outcome().answer()).writes();
        model.fill(old -> old.withRule(FillRule.NON_ZERO));
        long nonZero = ((PixelAnswer) outcome().answer()).writes();
        assertTrue(nonZero > evenOdd + 50, evenOdd + " pixels, then " + nonZero);
    }

    @Test
    void rowsTableSumsToNothingBeyondTheLastCrossing() {
        model.chooseMode(PolygonMode.FILL);
        var answer = (PixelAnswer) outcome().answer();
        assertFalse(answer.crossings().isEmpty());
        answer.crossings()
                .forEach(
                        (row, crossings) -> {
                            int sum = 0;
                            double before = Double.NEGATIVE_INFINITY;
                            for (var each : crossings) {
                                sum += each.winding();
                                assertTrue(each.x() >= before, "row " + row);
                                before = each.x();
                            }
                            assertEquals(0, sum, "row " + row);
                        });
    }

    @Test
    void faultyTrianglesAreToldApart() {
        model.show(PolygonMode.TRIANGULATION, "corner-in-the-ear");
        model.chooseMethod("shortest-diagonal-textbook");
        var cuts = ((CutAnswer) outcome().answer()).cuts();
        assertEquals(CutAnswer.TriangleFault.HOLDS_A_CORNER, cuts.get(0).fault());
        assertEquals(CutAnswer.TriangleFault.CLOCKWISE, cuts.get(1).fault());
        model.chooseMethod("ear-clipping");
        ((CutAnswer) outcome().answer())
                .cuts()
                .forEach(cut -> assertEquals(CutAnswer.TriangleFault.NONE, cut.fault()));
    }

    @Test
    void pointOnASideIsWronglyJudgedOutside() {
        model.chooseMethod("sign-double");
        assertTrue(((InsideAnswer) outcome().answer()).isWrong(0));
        model.move(Grip.POINT, 4, 2);
        assertFalse(((InsideAnswer) outcome().answer()).isWrong(0));
    }

    @Test
    void pointOnASideIsSaidToBeThereAndNotBesideIt() {
        model.chooseMethod("sign-double");
        settle();
        assertEquals("on the side (within 1 ulp)", worst(Language.ENGLISH));
        assertEquals("на стороне (до 1 ulp)", worst(Language.RUSSIAN));
        model.move(Grip.POINT, 4, 2);
        settle();
        assertEquals("none", worst(Language.ENGLISH));
        assertEquals("нет", worst(Language.RUSSIAN));
    }

    private String worst(Language language) {
        return new PolygonReadings(model.state(), Texts.of("polygon", language)).worst();
    }

    @Test
    void numbersSayThatTheyAreAboutThePointAlone() {
        model.chooseMethod("sign-double");
        model.compareWith("robust");
        settle();
        assertEquals(List.of("at P", "not at P", "right at P"), numbers(Language.ENGLISH));
        assertEquals(List.of("в P", "в P\u00a0— нет", "в P верно"), numbers(Language.RUSSIAN));
        model.show(PolygonMode.TRIANGLE, "past-2-15");
        settle();
        int points = inside().points().size();
        String some = "[0-9]+ of " + points + " points";
        String one = "(not )?at P";
        for (String said : numbers(Language.ENGLISH).subList(0, 2))
            assertTrue(said.matches(points == 1 ? one : some), said);
    }

    @ParameterizedTest(name = "a step tells what only the result shows: {0}")
    @EnumSource(PolygonMode.class)
    void whatIsWrongIsKnownAtTheEnd(PolygonMode mode) {
        model.chooseMode(mode);
        settle();
        model.goTo(1);
        assertFalse(model.state().finished());
        var readings = new PolygonReadings(model.state(), Texts.of("polygon", Language.ENGLISH));
        for (String said : List.of(readings.missing(), readings.extra(), readings.worst()))
            assertEquals("known at the end", said);
        model.goTo(model.last());
        assertFalse(numbers(Language.ENGLISH).contains("known at the end"));
    }

    @Test
    @DisplayName("an answer that never came has numbers")
    void nothingIsToldOfAnAnswerThatNeverCame() {
        var read = new HashSet<String>();
        for (PolygonMode mode : PolygonMode.values()) {
            var kinds = EnumSet.of(Verdict.Kind.ENDLESS, Verdict.Kind.CRASHED);
            for (Hazard<?> hazard : model.hazards(mode))
                for (String method : model.methods(mode)) {
                    if (!kinds.remove(hazard.recorded().get(method))) continue;
                    model.chooseMode(mode);
                    model.chooseMethod(method);
                    model.show(mode, hazard.name());
                    settle();
                    var shown =
                            new PolygonReadings(
                                    model.state(), Texts.of("polygon", Language.ENGLISH));
                    read.add(shown.missing() + shown.extra() + shown.worst());
                }
        }
        assertEquals(Set.of("–––"), read);
    }

    private List<String> numbers(Language language) {
        var readings = new PolygonReadings(model.state(), Texts.of("polygon", language));
        return List.of(readings.missing(), readings.extra(), readings.other());
    }

    @Test
    @DisplayName("undo of a move changes the view, or undo of a hazard leaves it there")
    void undoBringsBackTheViewOfItsFigure() {
        int before = model.state().arrangement();
        model.move(Grip.POINT, 4, 2);
        model.history().undo();
        assertEquals(before, model.state().arrangement());
        model.show(PolygonMode.TRIANGLE, "huge");
        assertTrue(model.state().arrangement() != before);
        model.history().undo();
        assertEquals(before, model.state().arrangement());
        settle();
    }

    @Test
    void comparesTwoMethods() {
        model.chooseMethod("sign-double");
        model.compareWith("robust");
        settle();
        MethodOutcome other = model.state().results().other().orElseThrow();
        assertEquals("robust", other.method());
        assertTrue(other.isRight());
        assertFalse(model.state().results().outcome().isRight());
    }

    @Test
    void unknownNamesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> model.chooseMethod("guess"));
        assertThrows(IllegalArgumentException.class, () -> model.show(PolygonMode.FILL, "no-such"));
    }

    @Test
    void nextPointOfAHazardIsJudgedStepByStep() {
        model.show(PolygonMode.TRIANGLE, "past-2-15");
        PolygonPoint second = inside().points().get(1);
        int points = inside().points().size();
        model.nextPoint();
        assertEquals(second, inside().points().get(0));
        assertEquals(points, inside().points().size());
    }
}
