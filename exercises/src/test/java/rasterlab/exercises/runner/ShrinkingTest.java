package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.proving.GradedMethod;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.PixelRows;
import rasterlab.exercises.topic.TopicGradings;

/** The smallest input on which a property breaks takes the place of the first. */
class ShrinkingTest {
    private static final LineRasterizer RIGHT = new BresenhamLine();

    /** Draws right but for the last pixel of lines that go five pixels to the left or more. */
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
        public Optional<TriedCall> aside(GradedCall call) {
            asked++;
            return asked > most ? Optional.empty() : Optional.of(tried(call, method));
        }

        @Override
        public Duration spentAside() {
            return pace.multipliedBy(asked);
        }
    }

    private static TriedCall tried(GradedCall call, LineRasterizer method) {
        return TriedCall.answered(call, GradedMethod.answer(call, method));
    }

    private static GradedCall call(String from, String to) {
        String input = "{\"count\": 1, \"given\": {\"from\": %s, \"to\": %s}}".formatted(from, to);
        Case one =
                new Case(
                        "a-case",
                        Map.of(),
                        "a-case",
                        Criterion.ACCURACY,
                        Disclosure.VERDICT_ONLY,
                        1,
                        input,
                        true,
                        Optional.of("reversal"));
        return TopicGradings.named("line").calls(one, new ExerciseTolerance(true), 1).get(0);
    }

    private static final GradedCall LONG = call("[-217, 93]", "[-180, 106]");

    @Test
    void theSmallestCounterexampleIsFound() throws InterruptedException {
        Here student = new Here(LEFT_IS_LOW, Duration.ZERO);
        TriedCall shrunk = new Shrinking(student).of(tried(LONG, LEFT_IS_LOW));
        assertEquals("{\"from\":[0,0],\"to\":[-5,1]}", shrunk.call().input().toString());
        assertTrue(student.asked <= Shrinking.MOST_CALLS, student.asked + " calls");
        String said = shrunk.shown().message().in("en");
        assertTrue(
                said.contains("smallest counterexample: {\"from\":[0,0],\"to\":[-5,1]}")
                        && said.contains("beside it: {\"from\":[-5,1],\"to\":[0,0]}")
                        && said.contains("y of pixel 1 is 1; by the property it is 4")
                        && said.contains("wrong is the answer to the counterexample itself")
                        && said.split("\"to\":\\[-5,1]", -1).length == 2,
                said);
        assertEquals(3, shrunk.shown().pictures().size());
    }

    /** Rounds towards 0 what is to be rounded to the nearest, so it is wrong from either end. */
    private static void truncated(int x0, int y0, int x1, int y1, Pixels out) {
        int n = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0));
        for (int k = 0; k <= n; k++)
            out.plot(x0 + (x1 - x0) * k / n, y0 + (int) (k * (double) (y1 - y0) / n));
    }

    @Test
    void expectedIsTheRightAnswerWhereTheOneToTheInputItselfIsWrong() {
        TriedCall wrong = tried(call("[0, 0]", "[5, -1]"), ShrinkingTest::truncated);
        assertPictures(wrong, List.of("...###", "###..."), List.of(".....#", "#####."));
        assertOpens(wrong, "[0,0]", "[5,-1]");
    }

    @Test
    void expectedIsTheRightAnswerWhereTheOneToTheInputBesideItIsWrong() {
        TriedCall wrong = tried(call("[0, 0]", "[5, 1]"), LEFT_IS_LOW);
        assertPictures(
                wrong,
                List.of("###...", "...###", "......", "......"),
                List.of(".##...", "...###", "......", "#....."));
        assertOpens(wrong, "[5,1]", "[0,0]");
    }

    private static void assertPictures(
            TriedCall wrong, List<String> expected, List<String> actual) {
        List<CasePicture> pictures = wrong.shown().pictures();
        assertEquals(expected, rows(pictures, CasePicture.EXPECTED));
        assertEquals(actual, rows(pictures, CasePicture.ACTUAL));
    }

    private static List<String> rows(List<CasePicture> pictures, String kind) {
        CasePicture picture = CasePicture.of(pictures, kind).orElseThrow();
        return PixelRows.of(picture.text().in("en"), picture.part());
    }

    /** The lab is to show the input that the pictures are of. */
    private static void assertOpens(TriedCall wrong, String from, String to) {
        String scene = wrong.call().scene(wrong.answer()).replaceAll("\\s", "");
        assertTrue(scene.contains("\"from\":" + from + ",\"to\":" + to), scene);
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
