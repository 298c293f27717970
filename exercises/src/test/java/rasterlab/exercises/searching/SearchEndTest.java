package rasterlab.exercises.searching;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

class SearchEndTest {
    /** Ample for the first input also on a busy machine. */
    private static final Duration AMPLE = Duration.ofSeconds(8);

    /** Far longer than any search here, also on a busy machine. */
    private static final Duration GUARD = Duration.ofMinutes(2);

    private static final LineTopic LINE = new LineTopic();
    private static final LineRasterizer RIGHT = LINE.method("bresenham").implementation();
    private static final LineRasterizer WRONG =
            (x0, y0, x1, y1, out) -> {
                out.plot(x0, y0);
                out.plot(x0, y0 + 7);
            };

    /** Comes to no end before it is let go, interrupted or not. */
    private static final class Stuck {
        private final CountDownLatch free = new CountDownLatch(1);

        void here() {
            boolean waiting = true;
            while (waiting) {
                try {
                    free.await();
                    waiting = false;
                } catch (InterruptedException goesOn) {
                    continue;
                }
            }
        }
    }

    /** The topic of lines with other methods, and something that happens at each comparison. */
    private record Lines(List<Method<LineRasterizer>> methods, Runnable comparing)
            implements Topic<LineRasterizer, Segment, PixelRecording> {
        @Override
        public String name() {
            return LINE.name();
        }

        @Override
        public String lab() {
            return LINE.lab();
        }

        @Override
        public Class<LineRasterizer> contract() {
            return LINE.contract();
        }

        @Override
        public List<Hazard<Segment>> hazards() {
            return LINE.hazards();
        }

        @Override
        public List<Workload<Segment>> workloads() {
            return List.of(new Workload<>("short", 4, List.of(new Segment(0, 0, 3, 1))));
        }

        @Override
        public PixelRecording run(LineRasterizer method, Segment input, int limit) {
            return LINE.run(method, input, limit);
        }

        @Override
        public long spend(LineRasterizer method, Segment input) {
            return LINE.spend(method, input);
        }

        @Override
        public PixelRecording exact(Segment input, int limit) {
            return LINE.exact(input, limit);
        }

        @Override
        public Deviation compare(Segment input, PixelRecording exact, PixelRecording actual) {
            if (exact != actual) comparing.run();
            return LINE.compare(input, exact, actual);
        }

        @Override
        public Format<LineRasterizer, Segment, PixelRecording> format() {
            return LINE.format();
        }

        @Override
        public String item() {
            return LINE.item();
        }

        @Override
        public String errorUnit() {
            return LINE.errorUnit();
        }
    }

    private HazardSearch<?, ?, ?> search(
            LineRasterizer method, LineRasterizer witness, Runnable comparing) {
        var methods = List.of(Method.failing("searched", method), Method.right("witness", witness));
        return HazardSearch.of(new Lines(methods, comparing), "searched", 3, told);
    }

    private final Told told = new Told();

    private static final class Told implements SearchListener {
        private volatile boolean found;

        @Override
        public void tried(long inputs) {}

        @Override
        public void found(Find find) {
            found = true;
        }

        @Override
        public void simpler(Find find) {}
    }

    @Test
    void searchEndsThoughAComparisonDoesNot() {
        var stuck = new Stuck();
        var reached = new AtomicBoolean();
        HazardSearch<?, ?, ?> search =
                search(
                        WRONG,
                        RIGHT,
                        () -> {
                            reached.set(true);
                            stuck.here();
                        });
        Optional<Find> found =
                assertTimeoutPreemptively(GUARD, () -> search.search(AMPLE, () -> false));
        stuck.free.countDown();
        assertTrue(reached.get());
        assertEquals(Optional.empty(), found);
    }

    @Test
    void whatWasFoundIsKeptThoughMakingItSimplerComesToNoEnd() {
        var stuck = new Stuck();
        HazardSearch<?, ?, ?> search =
                search(
                        WRONG,
                        RIGHT,
                        () -> {
                            if (told.found) stuck.here();
                        });
        Optional<Find> found =
                assertTimeoutPreemptively(GUARD, () -> search.search(AMPLE, () -> false));
        stuck.free.countDown();
        assertEquals("searched", found.orElseThrow().method());
    }

    @Test
    void searchEndsThoughTheMethodNeverDoes() {
        var stuck = new Stuck();
        HazardSearch<?, ?, ?> search =
                search((x0, y0, x1, y1, out) -> stuck.here(), RIGHT, () -> {});
        Optional<Find> found =
                assertTimeoutPreemptively(GUARD, () -> search.search(AMPLE, () -> false));
        stuck.free.countDown();
        assertTrue(found.isPresent());
    }

    @Test
    void nothingIsCalledAfterTheStop() {
        var stopped = new AtomicBoolean();
        var callsLater = new AtomicInteger();
        HazardSearch<?, ?, ?> search =
                search(
                        (x0, y0, x1, y1, out) -> {
                            if (stopped.getAndSet(true)) callsLater.incrementAndGet();
                            WRONG.draw(x0, y0, x1, y1, out);
                        },
                        (x0, y0, x1, y1, out) -> {
                            if (stopped.get()) callsLater.incrementAndGet();
                            RIGHT.draw(x0, y0, x1, y1, out);
                        },
                        () -> {});
        search.search(GUARD, stopped::get);
        assertTrue(stopped.get());
        assertEquals(0, callsLater.get());
    }
}
