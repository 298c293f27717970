package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Verdict.Kind;

/** Methods that misbehave in every way there is, and the verdict each gets. */
class HazardTrialTest {
    private static final Segment SEGMENT = new Segment(0, 0, 9, 4);
    private static final Segment LONG = new Segment(0, 0, 2_000_000_000, 4);
    private static final Duration AMPLE = Duration.ofMinutes(2);

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("misbehaviour")
    void givesTheVerdict(LineRasterizer method, Segment segment, Kind kind, String detail) {
        Verdict verdict = judge(method, segment, AMPLE);
        assertEquals(kind, verdict.kind(), verdict.detail());
        assertTrue(verdict.detail().contains(detail), verdict.detail());
        assertTrue(verdict.detail().lines().count() <= 1, verdict.detail());
    }

    static Stream<Arguments> misbehaviour() {
        return Stream.of(
                argumentSet("right one", right(), SEGMENT, Kind.EXACT, ""),
                argumentSet(
                        "right one on a line longer than the limit", right(), LONG, Kind.EXACT, ""),
                argumentSet(
                        "moved one down",
                        moved(1),
                        SEGMENT,
                        Kind.DEGRADED,
                        "(0, 0) is missing, (0, 1)"),
                argumentSet(
                        "moved two down",
                        moved(2),
                        SEGMENT,
                        Kind.WRONG,
                        "(0, 0) is missing, (0, 2)"),
                argumentSet(
                        "moved by what the topic lets pass",
                        moved(3),
                        SEGMENT,
                        Kind.EXACT,
                        "(0, 0) is missing, (0, 3)"),
                argumentSet(
                        "an answer so misshapen that comparing throws",
                        moved(4),
                        SEGMENT,
                        Kind.WRONG,
                        "its answer cannot be compared: java.lang.IndexOutOfBoundsException"),
                argumentSet(
                        "wrong on a line longer than the limit",
                        moved(2),
                        LONG,
                        Kind.WRONG,
                        "(0, 2)"),
                argumentSet(
                        "plots for ever", forever(), SEGMENT, Kind.ENDLESS, "1020 pixels where 10"),
                argumentSet("draws nothing", nothing(), SEGMENT, Kind.WRONG, "(0, 0) is missing"),
                argumentSet(
                        "refuses",
                        throwing(new IllegalArgumentException("x0 = 0\nis low")),
                        SEGMENT,
                        Kind.REFUSED,
                        "x0 = 0 is low"),
                argumentSet(
                        "refuses without a word",
                        throwing(new IllegalArgumentException()),
                        SEGMENT,
                        Kind.CRASHED,
                        "IllegalArgumentException"),
                argumentSet(
                        "throws",
                        throwing(new ArithmeticException("/ by zero")),
                        SEGMENT,
                        Kind.CRASHED,
                        "ArithmeticException: / by zero at "),
                argumentSet(
                        "recursion without end",
                        (LineRasterizer) HazardTrialTest::recursive,
                        SEGMENT,
                        Kind.CRASHED,
                        "StackOverflowError"),
                argumentSet(
                        "takes all memory",
                        (LineRasterizer) HazardTrialTest::greedy,
                        SEGMENT,
                        Kind.CRASHED,
                        "OutOfMemoryError"));
    }

    @Test
    void aLoopThatPlotsNothingIsEndlessByTheClock() {
        var stop = new CountDownLatch(1);
        LineRasterizer stuck = (x0, y0, x1, y1, out) -> awaitUninterrupted(stop);
        Verdict verdict = judge(stuck, SEGMENT, Duration.ofMillis(50));
        stop.countDown();
        assertEquals(Kind.ENDLESS, verdict.kind());
        assertEquals("no answer within 50 ms", verdict.detail());
    }

    @Test
    void aMethodThatSwallowsTheLimitIsStillStopped() {
        LineRasterizer stubborn =
                (x0, y0, x1, y1, out) -> {
                    try {
                        forever().draw(x0, y0, x1, y1, out);
                    } catch (LimitReached e) {
                        assertEquals("stopped after 1020 items", e.getMessage());
                    }
                };
        assertEquals(Kind.WRONG, judge(stubborn, SEGMENT, AMPLE).kind());
    }

    @Test
    void aMethodRunsOnAThreadThatDoesNotKeepTheProcessAlive() {
        LineRasterizer curious =
                (x0, y0, x1, y1, out) -> {
                    if (Thread.currentThread().isDaemon()) right().draw(x0, y0, x1, y1, out);
                };
        assertEquals(Kind.EXACT, judge(curious, SEGMENT, AMPLE).kind());
    }

    @Test
    void theTableNamesEveryMethodOnEveryHazard() {
        var topic = new LinesOf(List.of(named("right", right()), named("never", nothing())));
        List<HazardTrial.VerdictCell> table = HazardTrial.table(topic, AMPLE);
        assertEquals(
                List.of("right", "never"),
                table.stream().map(HazardTrial.VerdictCell::method).toList());
        assertEquals("made-up", table.get(0).hazard());
        assertTrue(table.get(0).asRecorded() && !table.get(1).asRecorded(), table.toString());
    }

    @Test
    void whatWasMadeStandsBesideWhatIsRight() {
        Method<LineRasterizer> low = named("low", moved(2));
        Method<LineRasterizer> none = named("none", throwing(new IllegalArgumentException("no")));
        var topic = new LinesOf(List.of(low, none));
        var tried = HazardTrial.tried(topic, low, SEGMENT, AMPLE);
        var exact = topic.exact(SEGMENT, 100);
        assertTrue(topic.compare(SEGMENT, exact, tried.exact()).exact());
        var made = topic.record(low.implementation(), SEGMENT, 100);
        assertTrue(topic.compare(SEGMENT, made, tried.made().orElseThrow()).exact());
        assertEquals(Kind.WRONG, tried.verdict().kind());
        assertTrue(HazardTrial.tried(topic, none, SEGMENT, AMPLE).made().isEmpty());
    }

    static LineRasterizer right() {
        return new BresenhamLine();
    }

    static LineRasterizer forever() {
        return (x0, y0, x1, y1, out) -> {
            while (true) out.plot(x0, y0);
        };
    }

    static LineRasterizer nothing() {
        return (x0, y0, x1, y1, out) -> {};
    }

    static LineRasterizer throwing(RuntimeException e) {
        return (x0, y0, x1, y1, out) -> {
            throw e;
        };
    }

    private static LineRasterizer moved(int down) {
        return (x0, y0, x1, y1, out) ->
                right().draw(x0, y0, x1, y1, (x, y) -> out.plot(x, y + down));
    }

    private static void recursive(int x0, int y0, int x1, int y1, Pixels out) {
        recursive(x0 + 1, y0, x1, y1, out);
    }

    private static void greedy(int x0, int y0, int x1, int y1, Pixels out) {
        out.plot(x0, new long[Integer.MAX_VALUE].length);
    }

    private static void awaitUninterrupted(CountDownLatch stop) {
        boolean waiting = true;
        while (waiting) {
            try {
                stop.await();
                waiting = false;
            } catch (InterruptedException e) {
                waiting = true; // a method that does not listen
            }
        }
    }

    private static Verdict judge(LineRasterizer method, Segment segment, Duration limit) {
        Method<LineRasterizer> named = named("made-up", method);
        var topic = new LinesOf(List.of(named));
        return HazardTrial.judge(topic, named, LinesOf.hazard(segment), limit);
    }

    private static Method<LineRasterizer> named(String name, LineRasterizer method) {
        return LinesOf.method(name, method);
    }
}
