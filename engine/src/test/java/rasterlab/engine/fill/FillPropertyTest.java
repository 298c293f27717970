package rasterlab.engine.fill;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.PixelRecording;

/** Checks properties of every right fill on pictures that shrink to the smallest counterexample. */
class FillPropertyTest {
    private static final FillTopic TOPIC = new FillTopic();
    private static final List<SteppedFill> RIGHT = List.of(new StackFill(), new SpanFill());

    @Provide
    Arbitrary<FillTask> tasks() {
        Arbitrary<Integer> side = Arbitraries.integers().between(1, 14);
        return Combinators.combine(side, side)
                .flatAs(
                        (width, height) ->
                                Combinators.combine(
                                                rows(width, height),
                                                Arbitraries.integers().between(0, width - 1),
                                                Arbitraries.integers().between(0, height - 1),
                                                Arbitraries.of((int) '*', (int) '.', (int) '#'),
                                                Arbitraries.of(4, 8))
                                        .as(FillTask::new));
    }

    private static Arbitrary<List<String>> rows(int width, int height) {
        Arbitrary<String> row = Arbitraries.strings().withChars("...##").ofLength(width);
        return row.list().ofSize(height);
    }

    @Property(tries = 3000)
    void eachPixelOfTheRegionIsWrittenOnceAndNoOther(@ForAll("tasks") FillTask task) {
        PixelRecording exact = TOPIC.exact(task, 10_000);
        for (SteppedFill method : RIGHT) {
            PixelRecording drawn = TOPIC.record(method, task, 10_000);
            assertTrue(TOPIC.compare(task, exact, drawn).exact(), method + ", " + task.rows());
        }
    }

    /** The walk's runs, joined, are the writes. */
    @Property(tries = 500)
    void theStepsAreThePixelsWritten(@ForAll("tasks") FillTask task) {
        for (SteppedFill method : RIGHT) {
            var picture = new TextPicture(task.rows());
            var runs = new HashSet<List<Integer>>();
            FillWalk walk =
                    method.walk(picture, task.x(), task.y(), task.with(), task.connectivity());
            while (walk.advance())
                for (int x = walk.from(); x < walk.to(); x++)
                    assertTrue(runs.add(List.of(x, walk.y())), x + ", " + walk.y());
            assertEquals(pixels(TOPIC.exact(task, 10_000)), runs);
        }
    }

    /** Every call fills one run, and the first waits for none. */
    @Property(tries = 500)
    void theRunsOfTheRecursiveFillAreThePixelsItWrites(@ForAll("tasks") FillTask task) {
        if (task.with() == '.' || task.with() == '#') return;
        var runs = new HashSet<List<Integer>>();
        var depths = new ArrayList<Integer>();
        new RecursiveTextbookFill()
                .trace(
                        new TextPicture(task.rows()),
                        task.x(),
                        task.y(),
                        task.with(),
                        task.connectivity(),
                        (y, from, to, waiting) -> {
                            for (int x = from; x < to; x++) runs.add(List.of(x, y));
                            depths.add(waiting);
                        });
        assertEquals(pixels(TOPIC.record(new RecursiveTextbookFill(), task, 10_000)), runs);
        assertEquals(0, depths.get(0));
        for (int i = 1; i < depths.size(); i++)
            assertTrue(depths.get(i) > 0 && depths.get(i) <= depths.get(i - 1) + 1, depths + "");
    }

    /** The second call of two from one run must not seem to wait for the first. */
    @Test
    void aCallThatHasEndedWaitsNoMore() {
        var waits = new ArrayList<Integer>();
        new RecursiveTextbookFill()
                .trace(
                        new TextPicture(List.of(".#.", "...")),
                        1,
                        1,
                        '*',
                        4,
                        (y, from, to, waiting) -> waits.add(waiting));
        assertEquals(List.of(0, 1, 1), waits);
    }

    private static Set<List<Integer>> pixels(PixelRecording recording) {
        var pixels = new HashSet<List<Integer>>();
        for (int i = 0; i < recording.size(); i++)
            pixels.add(List.of(recording.x(i), recording.y(i)));
        return pixels;
    }

    /** Four million pixels in one region, which recursion would not survive. */
    @Test
    void aLargeEmptyPictureIsFilled() {
        var task = new FillTask(Collections.nCopies(2000, ".".repeat(2000)), 7, 9, '*', 4);
        for (SteppedFill method : RIGHT) assertEquals(4_000_000, TOPIC.spend(method, task));
    }

    @Test
    void spansReadAPixelLessThanFourTimes() {
        for (var workload : TOPIC.workloads())
            for (FillTask task : workload.inputs()) {
                var counts = TOPIC.operations(new SpanFill(), task);
                long writes = counts.get("pixel writes");
                assertTrue(counts.get("pixel reads") < 4 * writes + 16, workload.name() + counts);
            }
    }
}
