package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.TopicGrading.Call;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.proving.TriedMethod;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.topic.TopicGradings;

/** The smallest input on which a property breaks takes the place of the first. */
class ShrinkingTest {
    private static final LineRasterizer RIGHT = new BresenhamLine();

    /** Right but for the last pixel of lines that go five pixels to the left or more. */
    private static final LineRasterizer LEFT_IS_LOW =
            (x0, y0, x1, y1, out) -> {
                boolean low = x1 <= x0 - 5;
                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(x, low && x == x1 ? y + 3 : y));
            };

    /** Asks a method here, at a pace. */
    private static final class Here implements Shrinking.Asking {
        private final LineRasterizer method;
        private final Duration pace;
        private int asked;
        private int most = Integer.MAX_VALUE;

        Here(LineRasterizer method, Duration pace) {
            this.method = method;
            this.pace = pace;
        }

        @Override
        public Optional<TriedCall> aside(Call call) {
            asked++;
            return asked > most ? Optional.empty() : Optional.of(tried(call, method));
        }

        @Override
        public Duration spentAside() {
            return pace.multipliedBy(asked);
        }
    }

    private static TriedCall tried(Call call, LineRasterizer method) {
        return TriedCall.answered(call, TriedMethod.answer(call, method));
    }

    private static Call call(String from, String to) {
        String input = "{\"count\": 1, \"given\": {\"from\": %s, \"to\": %s}}".formatted(from, to);
        Case one =
                new Case(
                        "a-case",
                        Map.of(),
                        "a-case",
                        Kind.ACCURACY,
                        Disclosure.VERDICT_ONLY,
                        1,
                        input,
                        true,
                        Optional.of("reversal"));
        return TopicGradings.named("line").calls(one, new Tolerance(true), 1).get(0);
    }

    private static final Call LONG = call("[-217, 93]", "[-180, 106]");

    @Test
    void theSmallestCounterexampleIsFound() throws InterruptedException {
        Here student = new Here(LEFT_IS_LOW, Duration.ZERO);
        TriedCall shrunk = new Shrinking(student).of(tried(LONG, LEFT_IS_LOW));
        assertEquals("{\"from\":[0,0],\"to\":[-5,1]}", shrunk.call().input().toString());
        assertTrue(student.asked <= Shrinking.MOST_CALLS, student.asked + " calls");
        String said = shrunk.shown().said().in("en");
        assertTrue(
                said.contains("smallest counterexample: {\"from\":[0,0],\"to\":[-5,1]}")
                        && said.contains("beside it: {\"from\":[-5,1],\"to\":[0,0]}")
                        && said.contains("y of pixel 1 is 1; by the property it is 4")
                        && said.contains("wrong is the answer to {\"from\":[0,0],\"to\":[-5,1]}"),
                said);
        assertEquals(3, shrunk.shown().pictures().size());
    }

    @Test
    void whatKeepsThePropertyIsNotShrunk() throws InterruptedException {
        Here student = new Here(RIGHT, Duration.ZERO);
        TriedCall right = tried(LONG, RIGHT);
        assertSame(right, new Shrinking(student).of(right));
        assertEquals(0, student.asked);
    }

    @Test
    void aMethodThatIsStoppedIsAskedNoMore() throws InterruptedException {
        Here student = new Here(LEFT_IS_LOW, Duration.ZERO);
        student.most = 3;
        new Shrinking(student).of(tried(LONG, LEFT_IS_LOW));
        assertEquals(4, student.asked);
    }

    @Test
    void aSlowMethodIsAskedNoLongerThanHalfASecond() throws InterruptedException {
        Here student = new Here(LEFT_IS_LOW, Duration.ofMillis(100));
        new Shrinking(student).of(tried(LONG, LEFT_IS_LOW));
        assertEquals(5, student.asked);
    }

    @Test
    void ofCallsThatGoWrongAlikeOneIsShrunk() throws InterruptedException {
        Here student = new Here(LEFT_IS_LOW, Duration.ZERO);
        Shrinking shrinking = new Shrinking(student);
        shrinking.of(tried(LONG, LEFT_IS_LOW));
        TriedCall second = tried(call("[40, 7]", "[61, 12]"), LEFT_IS_LOW);
        assertSame(second, shrinking.of(second));
    }
}
