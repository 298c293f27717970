package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.History;
import rasterlab.app.canvas.Kept;

/** Undo in a lab after a hazard was opened in it. */
class HazardUndoTest {
    private final LabModels models =
            LabModels.first(
                    answer -> {},
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void close() {
        models.close();
    }

    static Stream<Arguments> topics() {
        return Stream.of(
                topic(
                        "line",
                        "leftward",
                        "naive-textbook",
                        LabModels::line,
                        m -> m.line().history()),
                topic(
                        "clip-polygon",
                        "comb",
                        "weiler-atherton",
                        LabModels::clip,
                        m -> m.clip().history()));
    }

    private static Arguments topic(
            String topic,
            String hazard,
            String method,
            Function<LabModels, Kept<?>> lab,
            Function<LabModels, History<?>> history) {
        return Arguments.argumentSet(
                "hazard and method are two changes: " + topic, topic, hazard, method, lab, history);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("topics")
    void oneUndoBringsBackWhatWasThere(
            String topic,
            String hazard,
            String method,
            Function<LabModels, Kept<?>> lab,
            Function<LabModels, History<?>> history) {
        Object before = lab.apply(models).kept();
        var opening = new LabOpening(models, Runnable::run, Runnable::run, failure -> {});
        opening.showHazard(topic, hazard, method);
        assertNotEquals(before, lab.apply(models).kept());
        history.apply(models).undo();
        assertEquals(before, lab.apply(models).kept());
    }
}
