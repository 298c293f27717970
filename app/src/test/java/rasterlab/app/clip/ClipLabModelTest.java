package rasterlab.app.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.clip.outcome.ClipStep;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.PlaneSegment;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeSpace;
import rasterlab.app.clip.scene.VolumeViewpoint;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

@Timeout(300)
class ClipLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ClipLabModel model = new ClipLabModel(new ClipTopics(), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for the answers and hands them to the model. */
    private void settle() {
        thread.settle(model::settle);
    }

    private Clipping clipping() {
        settle();
        return model.state().results().clipping();
    }

    private ClipWindow window() {
        return model.state().choice().segments().window().rectangle();
    }

    @Test
    void opensWithAResultThatIsRightInEachMode() {
        for (ClipMode mode : ClipMode.values()) {
            model.chooseMode(mode);
            Clipping opened = clipping();
            assertEquals(Clipping.ClipEnding.ENDED, opened.ending(), mode.name());
            assertFalse(opened.parts().isEmpty(), mode.name());
            assertTrue(model.state().finished(), mode.name());
        }
    }

    @ParameterizedTest(name = "a step tells what only the result shows: {0}")
    @EnumSource(ClipMode.class)
    void whatIsWrongIsKnownAtTheEnd(ClipMode mode) {
        model.chooseMode(mode);
        model.compareWith(model.methods(mode).get(1));
        settle();
        model.goTo(1);
        assertEquals(List.of("known at the end"), wrong(Language.ENGLISH));
        assertEquals(List.of("видно в конце"), wrong(Language.RUSSIAN));
        model.goTo(model.last());
        assertFalse(wrong(Language.ENGLISH).contains("known at the end"));
    }

    @Test
    void smallErrorOfTheFirstSceneIsNotRaised() {
        assertTrue(clipping().deviation().worst() < 1e-12, clipping().deviation().toString());
    }

    @Test
    void nothingIsToldOfAnAnswerThatNeverCame() {
        model.chooseMethod("cohen-sutherland-nested-textbook");
        assertEquals(Clipping.ClipEnding.ENDLESS, clipping().ending());
        model.goTo(model.last());
        assertEquals(List.of("–", ""), wrong(Language.ENGLISH));
        assertEquals(List.of("–", ""), wrong(Language.RUSSIAN));
        model.chooseMethod("liang-barsky");
        model.compareWith("cohen-sutherland-nested-textbook");
        settle();
        model.goTo(model.last());
        assertTrue(wrong(Language.ENGLISH).contains("–"), wrong(Language.ENGLISH).toString());
    }

    private List<String> wrong(Language language) {
        var readings = new ClipReadings(model.state(), Texts.of("clip", language));
        return Stream.of(readings.missing(), readings.extra(), readings.worst(), readings.other())
                .distinct()
                .toList();
    }

    @Test
    void draggedCornerMovesItsTwoSidesOnly() {
        model.move(ClipGrip.window(2), 8, 5);
        assertEquals(new ClipWindow(0, 0, 8, 5), window());
        model.move(ClipGrip.window(0), -1, 1);
        assertEquals(new ClipWindow(-1, 1, 8, 5), window());
    }

    @Test
    void cornerStopsAtTheOppositeOne() {
        model.move(ClipGrip.window(0), 50, 50);
        assertEquals(new ClipWindow(10, 6, 10, 6), window());
    }

    @Test
    void dragIsOneChangeForUndo() {
        ClipChoice before = model.state().choice();
        model.beginDrag();
        for (int x = 0; x < 9; x++) model.move(ClipGrip.end(1, 1), x, 4);
        model.endDrag();
        assertEquals(new ClipPoint(8, 4), model.state().choice().segments().segments().get(1).b());
        model.history().undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void otherModeKeepsItsScene() {
        model.move(ClipGrip.end(0, 0), -2, -2);
        model.chooseMode(ClipMode.POLYGON);
        model.move(ClipGrip.corner(0), -9, 1);
        model.chooseMode(ClipMode.SEGMENTS);
        assertEquals(
                new ClipPoint(-2, -2), model.state().choice().segments().segments().get(0).a());
        assertEquals(new ClipPoint(-9, 1), model.state().choice().polygon().subject().get(0));
    }

    @Test
    void resetLeavesTheOtherModesAlone() {
        model.chooseMode(ClipMode.POLYGON);
        model.move(ClipGrip.corner(0), -9, 1);
        model.chooseMode(ClipMode.SEGMENTS);
        model.chooseMethod("midpoint");
        model.reset();
        assertEquals(SegmentScene.first(), model.state().choice().segments());
        assertEquals(new ClipPoint(-9, 1), model.state().choice().polygon().subject().get(0));
        model.history().undo();
        assertEquals("midpoint", model.state().choice().segments().method());
    }

    @Test
    void looksAtEachStepBetweenGivenAndResult() {
        model.chooseMethod("liang-barsky");
        List<ClipStep> steps = clipping().steps();
        assertEquals(steps.size() + 1, model.last());
        model.goTo(0);
        assertTrue(model.state().current().isEmpty());
        for (int step = 1; step <= steps.size(); step++) {
            model.goTo(step);
            assertEquals(steps.get(step - 1), model.state().current().orElseThrow());
        }
        model.goTo(model.last());
        assertTrue(model.state().finished());
    }

    @Test
    void editKeepsTheStepThatIsLookedAt() {
        model.chooseMethod("liang-barsky");
        settle();
        model.goTo(2);
        model.move(ClipGrip.end(0, 0), -3, -1);
        settle();
        assertEquals(2, model.step());
    }

    @Test
    void stepOfLiangBarskyStaysOnTheSegment() {
        model.chooseMethod("liang-barsky");
        for (ClipStep step : clipping().steps()) {
            PlaneSegment whole = model.state().choice().segments().segments().get(step.item());
            double dx = whole.b().x() - whole.a().x();
            double dy = whole.b().y() - whole.a().y();
            for (int end = 0; end < step.left().length; end += 2)
                assertEquals(
                        0,
                        (step.left()[end] - whole.a().x()) * dy
                                - (step.left()[end + 1] - whole.a().y()) * dx,
                        1e-9,
                        step.at() + " " + Arrays.toString(step.left()));
        }
    }

    @Test
    void stepNamesTheBorderItTests() {
        model.chooseMethod("liang-barsky");
        List<Integer> borders = clipping().steps().stream().limit(4).map(ClipStep::border).toList();
        assertEquals(List.of(3, 1, 0, 2), borders, "left, right, bottom, top");
        List<ClipStep.Passing> passings =
                clipping().steps().stream().limit(4).map(ClipStep::passing).toList();
        assertEquals(
                List.of(
                        ClipStep.Passing.ENTERING,
                        ClipStep.Passing.LEAVING,
                        ClipStep.Passing.ENTERING,
                        ClipStep.Passing.LEAVING),
                passings);
    }

    /** The listing's y grows downward: what it calls top is the side at the smaller y. */
    @Test
    void topOfTheListingIsTheBottomSide() {
        model.chooseMethod("cohen-sutherland-textbook");
        model.show(ClipMode.SEGMENTS, "only-below");
        ClipStep step = clipping().steps().get(0);
        assertEquals("top", step.at());
        assertEquals(0, step.border());
    }

    @Test
    void endlessMethodIsCutAndTheOtherSegmentsGoOn() {
        model.chooseMethod("cohen-sutherland-nested-textbook");
        Clipping endless = clipping();
        assertEquals(Clipping.ClipEnding.ENDLESS, endless.ending());
        assertTrue(endless.part(0).isEmpty());
        assertTrue(endless.part(3).isPresent());
    }

    @Test
    void convexWindowIsClippedByCyrusBeck() {
        model.shapeWindow(false);
        assertEquals("cyrus-beck", model.state().choice().segments().method());
        assertTrue(clipping().isRight());
        assertEquals(List.of(0, 1, 2), borders(clipping(), 3));
        model.chooseMethod("midpoint");
        assertEquals(Clipping.ClipEnding.REFUSED, clipping().ending());
        model.shapeWindow(true);
        assertTrue(clipping().isRight());
    }

    private static List<Integer> borders(Clipping clipping, int first) {
        return clipping.steps().stream().limit(first).map(ClipStep::border).toList();
    }

    @Test
    void hollowWindowIsRefusedAndNothingIsExact() {
        model.shapeWindow(false);
        model.move(ClipGrip.window(1), 4, 4);
        assertEquals(Clipping.ClipEnding.REFUSED, clipping().ending());
        assertEquals(List.of(), model.state().results().exact());
    }

    @Test
    void bridgesAreToldFromThePieces() {
        model.chooseMode(ClipMode.POLYGON);
        Clipping bridged = clipping();
        assertEquals(1, bridged.parts().size());
        assertEquals(3, model.state().results().exact().size());
        assertTrue(bridged.wrong().missing().isEmpty());
        assertFalse(bridged.wrong().extra().isEmpty());
        for (double[] bridge : bridged.wrong().extra())
            assertEquals(0, Math.abs(bridge[0]) + Math.abs(bridge[2]), "on the side x = 0");
        model.chooseMethod("weiler-atherton");
        assertTrue(clipping().isRight());
    }

    @Test
    void pointIsMovedWhereItIsSeen() {
        model.chooseMode(ClipMode.VOLUME);
        for (VolumeSpace space : List.of(VolumeSpace.EYE, VolumeSpace.NORMALIZED)) {
            model.volume(old -> old.withSpace(space).withView(new VolumeViewpoint(-30, 25)));
            model.move(ClipGrip.end(0, 1), 0.3, -0.4);
            ClipPoint seen = model.state().choice().volume().grips().get(ClipGrip.end(0, 1));
            assertEquals(0.3, seen.x(), 1e-12, space.name());
            assertEquals(-0.4, seen.y(), 1e-12, space.name());
        }
    }

    @Test
    void selectedSegmentIsRemovedAndTheLastOneStays() {
        model.select(ClipGrip.end(2, 1));
        model.shrink();
        assertEquals(3, model.state().choice().segments().segments().size());
        for (int i = 0; i < 5; i++) model.shrink();
        assertEquals(1, model.state().choice().segments().segments().size());
        assertEquals(ClipGrip.end(0, 0), model.state().selected());
        model.grow();
        assertEquals(2, model.state().choice().segments().segments().size());
    }

    @Test
    void pointThatAnotherModeLacksIsNotSelectedThere() {
        model.chooseMode(ClipMode.POLYGON);
        model.select(ClipGrip.corner(7));
        model.chooseMode(ClipMode.VOLUME);
        assertEquals(ClipGrip.end(0, 0), model.state().selected());
    }

    @Test
    void unknownMethodIsRefusedByName() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class, () -> model.chooseMethod("homogeneous"));
        assertTrue(refused.getMessage().contains("liang-barsky"), refused.getMessage());
    }

    @ParameterizedTest(name = "a method''s verdict on a hazard is another in the lab: {0}")
    @EnumSource(ClipMode.class)
    void showsEachHazardAsRecorded(ClipMode mode) {
        var wrong = new ArrayList<String>();
        for (Hazard<?> hazard : model.hazards(mode))
            for (String method : model.methods(mode)) {
                model.chooseMode(mode);
                model.chooseMethod(method);
                model.show(mode, hazard.name());
                Verdict.Kind recorded = hazard.recorded().get(method);
                Clipping shown = clipping();
                if (!fits(recorded, shown))
                    wrong.add(
                            hazard.name()
                                    + " by "
                                    + method
                                    + ": "
                                    + recorded
                                    + ", "
                                    + shown.ending());
            }
        assertEquals(List.of(), wrong);
    }

    /** An error too small for a picture is not marked; refusals of one segment end nothing else. */
    private static boolean fits(Verdict.Kind recorded, Clipping shown) {
        return switch (recorded) {
            case EXACT -> shown.isRight();
            case REFUSED -> shown.ending() == Clipping.ClipEnding.REFUSED;
            case ENDLESS -> shown.ending() == Clipping.ClipEnding.ENDLESS;
            case CRASHED -> shown.ending() == Clipping.ClipEnding.CRASHED;
            default -> shown.ending() == Clipping.ClipEnding.ENDED;
        };
    }

    static Stream<String> commands() {
        return Stream.of(ClipMode.values()).map(ClipMode::topic);
    }

    @ParameterizedTest(name = "the command names another topic: {0}")
    @MethodSource("commands")
    void commandNamesTopicMethodAndInput(String topic) {
        for (ClipMode mode : ClipMode.values())
            if (mode.topic().equals(topic)) model.chooseMode(mode);
        String command = ClipCommand.of(model.state().choice().scene());
        String method = model.state().choice().scene().method();
        assertTrue(command.endsWith("| ./lab run " + topic + " " + method), command);
    }

    @Test
    void commandKeepsEveryDigit() {
        model.move(ClipGrip.end(0, 0), -1.0 / 3, 2);
        String command = ClipCommand.of(model.state().choice().scene());
        assertTrue(command.contains("[-0.3333333333333333, 2, 12, 8]"), command);
        assertTrue(command.contains("\"window\": [0, 0, 10, 6]"), command);
    }
}
