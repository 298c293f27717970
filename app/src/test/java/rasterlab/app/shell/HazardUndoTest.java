package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.History;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineRoom;
import rasterlab.app.polygon.PolygonRoom;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityRoom;
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

    /** The model that shows a topic's hazards, with its history. */
    private record Lab(Kept<?> shown, History<?> history) {}

    private static Lab of(String topic) {
        return switch (Topics.named(topic).lab()) {
            case "line" -> topic.equals("line") ? line() : figures();
            case "polygon" ->
                    new Lab(MODELS.of(new PolygonRoom()), MODELS.of(new PolygonRoom()).history());
            case "clip" -> new Lab(MODELS.of(new ClipRoom()), MODELS.of(new ClipRoom()).history());
            case "visibility" ->
                    rows(topic, MODELS.of(new VisibilityRoom()).rows())
                            .orElse(
                                    new Lab(
                                            MODELS.of(new VisibilityRoom()),
                                            MODELS.of(new VisibilityRoom()).history()));
            case "light" ->
                    rows(topic, MODELS.of(new LightRoom()).rows())
                            .orElse(
                                    new Lab(
                                            MODELS.of(new LightRoom()),
                                            MODELS.of(new LightRoom()).history()));
            case "spline" -> topic.equals("curve") ? curve() : function();
            case "coordinates" -> coordinates(topic);
            default -> throw new AssertionError("what can be undone in the lab of " + topic + "?");
        };
    }

    private static Lab line() {
        return new Lab(MODELS.of(new LineRoom()), MODELS.of(new LineRoom()).history());
    }

    private static Lab figures() {
        return new Lab(
                MODELS.of(new LineRoom()).figures(), MODELS.of(new LineRoom()).figures().history());
    }

    private static Lab curve() {
        return new Lab(
                MODELS.of(new SplineRoom()).curve(), MODELS.of(new SplineRoom()).curve().history());
    }

    private static Lab function() {
        return new Lab(
                MODELS.of(new SplineRoom()).function(),
                MODELS.of(new SplineRoom()).function().history());
    }

    private static Optional<Lab> rows(String topic, RowLabModel rows) {
        return rows.topics().contains(topic)
                ? Optional.of(new Lab(rows, rows.history()))
                : Optional.empty();
    }

    private static Lab coordinates(String topic) {
        CoordinatesLabModel lab = MODELS.of(new CoordinatesRoom());
        return switch (topic) {
            case "rotate" -> new Lab(lab.rotation(), lab.rotation().history());
            case "line-plane" -> new Lab(lab.meeting(), lab.meeting().history());
            default -> new Lab(lab.transformations(), lab.transformations().history());
        };
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
        Lab lab = of(topic.name());
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
        return Topics.all().stream()
                .flatMap(
                        topic ->
                                Topics.all().stream()
                                        .filter(other -> !other.name().equals(topic.name()))
                                        .filter(other -> areOne(topic, other))
                                        .map(other -> leaving(topic, other)));
    }

    private static boolean areOne(Topic<?, ?, ?> topic, Topic<?, ?, ?> other) {
        return of(topic.name()).history() == of(other.name()).history();
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
        Lab lab = of(topic.name());
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
