package rasterlab.exercises.graded;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurveTracer;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.WindowedLineRasterizer;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.child.ContractCalls;

class TopicPartTest {
    static List<TopicPart<?, ?>> parts() {
        return TopicPart.all();
    }

    @ParameterizedTest(name = "{0} cannot be called in a child")
    @MethodSource("parts")
    void aChildCanBeCalledByEveryPart(TopicPart<?, ?> part) {
        assertEquals(1, ContractCalls.of(part.contract()).all().size());
    }

    /** There would otherwise be nothing to hold a student's speed against while it is prepared. */
    @ParameterizedTest(name = "no right method of the topic does {0}")
    @MethodSource("parts")
    void aRightMethodOfTheTopicDoesThePart(TopicPart<?, ?> part) {
        Topic<?, ?, ?> topic =
                Topics.all().stream()
                        .filter(one -> TopicPart.of(one).anyMatch(part::equals))
                        .findFirst()
                        .orElseThrow();
        assertTrue(
                topic.methods().stream()
                        .filter(one -> !one.faulty())
                        .map(one -> one.implementation())
                        .anyMatch(part.contract()::isInstance));
    }

    @Test
    void aMethodOfTheWholeTopicStaysItself() {
        Topic<?, ?, ?> curve = Topics.named("curve");
        Object adaptive = curve.method("adaptive").implementation();
        List<TopicPart<?, ?>> parts = TopicPart.of(curve).toList();
        assertEquals(2, parts.size());
        for (TopicPart<?, ?> part : parts) assertSame(adaptive, part.whole(adaptive));
    }

    @Test
    void aPartIsCalledForItsInputsAndRefusesOthers() {
        CurveEvaluator start = (curve, t, out) -> out.point(curve.x()[0], curve.y()[0]);
        var whole = (CurveTracer) part("curve", "CurveEvaluator").whole(start);
        var curve = new Curve(Curve.Kind.BEZIER, new double[] {3, 1}, new double[] {4, 1});
        var sent = new ArrayList<Double>();
        whole.at(curve, new double[] {0}, (x, y) -> sent.addAll(List.of(x, y)));
        assertEquals(List.of(3.0, 4.0), sent);
        assertThrows(IllegalArgumentException.class, () -> whole.flatten(curve, 1, (x, y) -> {}));
    }

    @Test
    void aWindowComesToTheMethodWithItsSidesInOrder() {
        var given = new ArrayList<Integer>();
        WindowedLineRasterizer part =
                (x0, y0, x1, y1, xmin, ymin, xmax, ymax, out) ->
                        given.addAll(List.of(x0, y0, x1, y1, xmin, ymin, xmax, ymax));
        Object whole = part("line", "WindowedLineRasterizer").whole(part);
        ((WindowedLineRasterizer) whole).draw(1, 2, 3, 4, 5, 6, 7, 8, (x, y) -> {});
        assertEquals(List.of(1, 2, 3, 4, 5, 6, 7, 8), given);
        assertThrows(
                IllegalArgumentException.class,
                () -> ((LineRasterizer) whole).draw(1, 2, 3, 4, (x, y) -> {}));
    }

    private static TopicPart<?, ?> part(String topic, String name) {
        return TopicPart.of(Topics.named(topic))
                .filter(one -> one.name().equals(name))
                .findFirst()
                .orElseThrow();
    }
}
