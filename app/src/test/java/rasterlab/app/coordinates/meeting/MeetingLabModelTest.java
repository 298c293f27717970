package rasterlab.app.coordinates.meeting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Lab;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.geometry.meeting.PlaneAndLines;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

class MeetingLabModelTest {
    private final MeetingLabModel model = new MeetingLabModel();

    static Stream<Hazard<PlaneAndLines>> hazards() {
        return new LinePlaneTopic().hazards().stream();
    }

    private MeetingReadings readings(Language language) {
        return new MeetingReadings(model, Texts.of("coordinates.meeting", language));
    }

    @ParameterizedTest(name = "lab and recorded verdict differ")
    @MethodSource("hazards")
    void everyHazardEndsAsItIsRecorded(Hazard<PlaneAndLines> hazard) {
        model.show(hazard.input());
        for (MeetingScene.MeetingAnswer each : model.scene().answers()) {
            Verdict.Kind recorded = hazard.recorded().get(each.method());
            String said = hazard.name() + ", " + each;
            assertEquals(recorded == Verdict.Kind.REFUSED, each.refused(), said);
            boolean right = recorded == Verdict.Kind.EXACT || recorded == Verdict.Kind.REFUSED;
            assertEquals(right, each.right(), said);
        }
    }

    @ParameterizedTest(name = "a magnitude leaves the picture")
    @MethodSource("hazards")
    void everyHazardHasAPictureOfUsualSize(Hazard<PlaneAndLines> hazard) {
        model.show(hazard.input());
        var all = MarkBounds.around(MeetingFigure.of(model.scene(), model.view()).marks());
        String said = hazard.name() + " " + all;
        assertTrue(all.getWidth() + all.getHeight() >= 1, said);
        assertTrue(Math.max(all.getWidth(), all.getHeight()) <= 4 * SideView.FARTHEST, said);
    }

    @Test
    void heightsInThePictureAreThoseAboveThePlane() {
        var from = model.view().spot(model.choice().line().from());
        var through = model.view().spot(model.choice().line().through());
        double unit = Math.sqrt(14);
        // The plane is 6x + 3y + 2z = 6, its normal 7 long.
        assertEquals(-6 / 7.0 / unit, from.y(), 1e-12);
        assertEquals(12 / 7.0 / unit, through.y(), 1e-12);
        assertEquals(1, Math.hypot(through.x() - from.x(), through.y() - from.y()), 1e-12);
        assertEquals(1 / 3.0, model.scene().exact(), 1e-15);
    }

    @Test
    void draggedPointGoesWhereTheMouseIsAndIsOneChangeForUndo() {
        MeetingChoice before = model.choice();
        model.beginDrag();
        for (double y = 0.1; y < 0.8; y += 0.1)
            model.move(MeetingLabModel.MeetingGrip.THROUGH, 0.7, y);
        model.move(MeetingLabModel.MeetingGrip.THROUGH, -0.3, 0.5);
        model.endDrag();
        StagePoint at = model.view().spot(model.choice().line().through());
        assertEquals(-0.3, at.x(), 1e-12);
        assertEquals(0.5, at.y(), 1e-12);
        model.history().undo();
        assertEquals(before, model.choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void pointIsNotDraggedOntoTheOther() {
        MeetingChoice before = model.choice();
        StagePoint from = model.view().spot(before.line().from());
        model.move(MeetingLabModel.MeetingGrip.THROUGH, from.x(), from.y());
        assertEquals(before, model.choice());
    }

    @ParameterizedTest(name = "what is out of sight is not told: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "three-points | ''",
                "parallel | They have no common point, or none within doubles",
                "vanishing-slope | The plane is too far away to be drawn at the line’s size",
                "nearly-parallel | They meet out of sight, at μ ="
            })
    void saysWhatIsOutOfSight(String hazard, String note) {
        model.show(named(hazard));
        String said = readings(Language.ENGLISH).note();
        assertEquals(note, said.replaceAll(" [0-9].*", ""));
    }

    private static PlaneAndLines named(String hazard) {
        return hazards()
                .filter(each -> each.name().equals(hazard))
                .findFirst()
                .orElseThrow()
                .input();
    }

    @Test
    void vectorsAreWrittenAsTheLanguageDoes() {
        assertEquals("(1, 2, 3)", readings(Language.ENGLISH).through());
        assertEquals("(1; 2; 3)", readings(Language.RUSSIAN).through());
    }

    @Test
    void copiedCommandAnswersTheSame() throws Exception {
        String command = MeetingCommand.of(model.choice()).orElseThrow();
        String json = command.substring(6, command.lastIndexOf('\''));
        var out = new ByteArrayOutputStream();
        int exit =
                Lab.run(
                        command.substring(command.indexOf("./lab") + 6).split(" "),
                        new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)),
                        new PrintStream(out),
                        System.err);
        assertEquals(0, exit);
        double mu = new ObjectMapper().readTree(out.toByteArray()).path("mu").asDouble();
        assertEquals(model.scene().chosen().mu(), mu, 1e-12);
    }

    @Test
    void planeWhoseNearestPointIsBeyondDoublesHasNoCommand() {
        model.show(named("vanishing-slope"));
        assertTrue(MeetingCommand.of(model.choice()).isPresent());
        var far = new Plane(new Vector(1e-200, 0, 0), 1e200);
        var choice = new MeetingChoice("formula", far, Optional.empty(), model.choice().line());
        assertEquals(Optional.empty(), MeetingCommand.of(choice));
    }

    @Test
    void unknownMethodIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> model.chooseMethod("guess"));
    }
}
