package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.History;
import rasterlab.app.canvas.Kept;
import rasterlab.app.canvas.ModelThread;
import rasterlab.app.row.RowLabModel;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

/** Undo in a lab after a hazard was opened in it. */
class HazardUndoTest {
    private static final ModelThread THREAD = new ModelThread();

    private static final LabModels MODELS =
            LabModels.first(
                    THREAD,
                    failure -> {
                        throw new AssertionError(failure);
                    });

    private final LabOpening opening =
            new LabOpening(MODELS, Runnable::run, Runnable::run, failure -> {});

    /** What shows a topic's hazards, and what can be undone there. */
    private record Lab(Kept<?> shown, History<?> history) {}

    private static Lab of(RowLabModel rows) {
        return new Lab(rows, rows.history());
    }

    private static Map<String, Lab> labs() {
        var line = new Lab(MODELS.line(), MODELS.line().history());
        var figures = new Lab(MODELS.line().figures(), MODELS.line().figures().history());
        var polygon = new Lab(MODELS.polygon(), MODELS.polygon().history());
        var clip = new Lab(MODELS.clip(), MODELS.clip().history());
        var seen = new Lab(MODELS.visibility(), MODELS.visibility().history());
        var light = new Lab(MODELS.light(), MODELS.light().history());
        var curve = new Lab(MODELS.spline().curve(), MODELS.spline().curve().history());
        var function = new Lab(MODELS.spline().function(), MODELS.spline().function().history());
        var lists = MODELS.coordinates().transformations();
        var turn = MODELS.coordinates().rotation();
        var meeting = MODELS.coordinates().meeting();
        return Map.ofEntries(
                Map.entry("line", line),
                Map.entry("circle", figures),
                Map.entry("ellipse", figures),
                Map.entry("point-in-triangle", polygon),
                Map.entry("point-in-polygon", polygon),
                Map.entry("triangulate", polygon),
                Map.entry("polygon-fill", polygon),
                Map.entry("fill", polygon),
                Map.entry("clip-segment", clip),
                Map.entry("clip-polygon", clip),
                Map.entry("clip-volume", clip),
                Map.entry("hidden-surfaces", seen),
                Map.entry("visible-faces", seen),
                Map.entry("depth-order", seen),
                Map.entry("depth-buffer", of(MODELS.visibility().rows())),
                Map.entry("depth-triangle", of(MODELS.visibility().rows())),
                Map.entry("texture-mapping", of(MODELS.light().rows())),
                Map.entry("texture-filter", of(MODELS.light().rows())),
                Map.entry("shade", light),
                Map.entry("shade-face", light),
                Map.entry("vertex-normals", light),
                Map.entry("color", light),
                Map.entry("curve", curve),
                Map.entry("spline-function", function),
                Map.entry("matrix", new Lab(lists, lists.history())),
                Map.entry("transform", new Lab(lists, lists.history())),
                Map.entry("view", new Lab(lists, lists.history())),
                Map.entry("rotate-axis", new Lab(lists, lists.history())),
                Map.entry("rotate", new Lab(turn, turn.history())),
                Map.entry("line-plane", new Lab(meeting, meeting.history())));
    }

    @AfterAll
    static void close() {
        MODELS.close();
    }

    static Stream<Arguments> topics() {
        return Topics.all().stream()
                .map(
                        topic ->
                                Arguments.argumentSet(
                                        "hazard and method are two changes: " + topic.name(),
                                        topic));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("topics")
    void oneUndoBringsBackWhatWasThere(Topic<?, ?, ?> topic) {
        Lab lab = labs().get(topic.name());
        String other = topic.methods().get(topic.methods().size() - 1).name();
        String usual = topic.methods().get(0).name();
        String last = topic.hazards().get(topic.hazards().size() - 1).name();
        for (Hazard<?> hazard : topic.hazards()) {
            String first = hazard.name().equals(last) ? topic.hazards().get(0).name() : last;
            opening.showHazard(topic.name(), first, usual);
            THREAD.runAll();
            Object before = lab.shown().kept();
            opening.showHazard(topic.name(), hazard.name(), other);
            assertNotEquals(before, lab.shown().kept(), hazard.name());
            lab.history().undo();
            assertEquals(before, lab.shown().kept(), hazard.name());
        }
    }

    static Stream<Arguments> neighbours() {
        Map<String, Lab> labs = labs();
        return Topics.all().stream()
                .filter(topic -> labs.containsKey(topic.name()))
                .flatMap(
                        topic ->
                                Topics.all().stream()
                                        .filter(other -> !other.name().equals(topic.name()))
                                        .filter(other -> areOne(labs, topic, other))
                                        .map(other -> leaving(topic, other)));
    }

    private static boolean areOne(
            Map<String, Lab> labs, Topic<?, ?, ?> topic, Topic<?, ?, ?> other) {
        return labs.containsKey(other.name())
                && labs.get(topic.name()).history() == labs.get(other.name()).history();
    }

    private static Arguments leaving(Topic<?, ?, ?> topic, Topic<?, ?, ?> other) {
        return Arguments.argumentSet(
                "what is not shown keeps the hazard: " + topic.name() + " after " + other.name(),
                topic,
                other);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("neighbours")
    void undoBringsBackWhatTheHazardHid(Topic<?, ?, ?> topic, Topic<?, ?, ?> other) {
        Lab lab = labs().get(topic.name());
        String method = topic.methods().get(0).name();
        String last = topic.hazards().get(topic.hazards().size() - 1).name();
        opening.showHazard(topic.name(), last, method);
        opening.showHazard(
                other.name(), other.hazards().get(0).name(), other.methods().get(0).name());
        THREAD.runAll();
        Object before = lab.shown().kept();
        opening.showHazard(topic.name(), topic.hazards().get(0).name(), method);
        lab.history().undo();
        assertEquals(before, lab.shown().kept());
    }
}
