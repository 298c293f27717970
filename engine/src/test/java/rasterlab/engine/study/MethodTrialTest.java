package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.scan.PolygonTask;

class MethodTrialTest {
    private static final StudySettings SHORT =
            new StudySettings(Duration.ZERO, Duration.ofMillis(1), 1, Duration.ofMinutes(2));

    /** The method behaves as long as it is judged, once for each input. */
    @Test
    void aMethodThatOverwritesItsInputOnlyWhenItIsTimedIsWrong() {
        var topic = new PolygonFillTopic();
        PolygonFiller right = topic.method("edge-function").implementation();
        Workload<PolygonTask> workload = topic.workloads().get(0);
        var calls = new int[1];
        PolygonFiller easier =
                (x, y, rule, width, height, out) -> {
                    right.fill(x, y, rule, width, height, out);
                    if (++calls[0] > workload.inputs().size()) x[0]++;
                };
        var trial =
                new MethodTrial<>(
                        topic,
                        Method.failing("easier", easier),
                        workload,
                        answers(topic, workload.inputs()),
                        SHORT);
        trial.judge();
        assertEquals(Verdict.Kind.EXACT, trial.measurement().kind());
        trial.round();
        assertEquals(Verdict.Kind.WRONG, trial.measurement().kind());
        assertEquals("it overwrote what it was given", trial.measurement().detail());
    }

    private static <C, I, O> List<ExactAnswer<O>> answers(Topic<C, I, O> topic, List<I> inputs) {
        return inputs.stream().map(input -> ExactAnswer.to(topic, input)).toList();
    }
}
