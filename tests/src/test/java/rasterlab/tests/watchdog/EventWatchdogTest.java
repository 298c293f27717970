package rasterlab.tests.watchdog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InvocationEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JDialog;
import org.joml.Matrix4d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.transform.GlMatrices;
import rasterlab.tests.display.OwnDisplay;

/** Each event here lasts until the watchdog has seen what it does. */
@Tag("slow")
@Timeout(300)
@ExtendWith(OwnDisplay.class)
class EventWatchdogTest {
    private static final long LIMIT_NANOS = TimeUnit.MINUTES.toNanos(1);

    @BeforeEach
    void hasDisplay() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
    }

    private interface Work {
        void run() throws Exception;
    }

    /** The report of the watchdog on an event that repeats something until it is noticed. */
    private static String fault(Work work) throws Exception {
        try (var watch = Watch.begin()) {
            EventQueue.invokeAndWait(() -> repeat(watch, work));
            List<String> faults = watch.takeFaults();
            assertEquals(1, faults.size(), "faults");
            return faults.get(0);
        }
    }

    /** Ends without a fault too: an event that goes on for ever would stop all tests after it. */
    private static void repeat(Watch watch, Work work) {
        var stay = new Stay(new ActionEvent("", 0, ""), Optional.empty());
        try {
            while (!watch.hasFault() && stay.age() < LIMIT_NANOS) work.run();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void listenerThatSleepsIsBlamed() throws Exception {
        String fault = fault(() -> TimeUnit.MILLISECONDS.sleep(5));
        assertTrue(fault.contains(Blame.WAITS.text()), fault);
        assertTrue(fault.contains("EventWatchdogTest.java"), fault);
    }

    @Test
    void listenerThatWaitsForAnotherThreadIsBlamed() throws Exception {
        var never = new CountDownLatch(1);
        String fault = fault(() -> never.await(5, TimeUnit.MILLISECONDS));
        assertTrue(fault.contains(Blame.WAITS.text()), fault);
    }

    @Test
    void listenerThatReadsAFileIsBlamed(@TempDir Path folder) throws Exception {
        Path file = Files.write(folder.resolve("large"), new byte[1 << 22]);
        String fault = fault(() -> Files.readAllBytes(file));
        assertTrue(fault.contains(Blame.READS.text()), fault);
    }

    /** The listener runs on one thread: with more, each waits for the others too. */
    @Test
    void listenerThatMakesAPictureIsBlamed() throws Exception {
        int corners = 30_000;
        float[][] place = new float[3][corners];
        int[] triangles = new int[corners];
        for (int v = 0; v < corners; v++) {
            triangles[v] = v;
            place[0][v] = v % 3 == 1 ? 1 : 0;
            place[1][v] = v % 3 == 2 ? 1 : 0;
            place[2][v] = -v / (float) corners;
        }
        var mesh = TriangleMesh.of(place[0], place[1], place[2], triangles);
        var toEye = new Matrix4d().translate(0, 0, -4);
        var view = new TriangleView(toEye, GlMatrices.perspective(45, 1, 1, 10));
        var surface = new Surface.Smooth(VertexColors.own());
        var out = new Raster(640, 640);
        try (var pipeline = new TrianglePipeline(1)) {
            String fault = fault(() -> pipeline.drawOn(0, mesh, view, surface, out, () -> false));
            assertTrue(fault.contains(Blame.WORKS.text()), fault);
        }
    }

    /** The event that opens it lasts as long as the dialog, whose loop keeps the thread free. */
    @Test
    void openDialogIsNotBlamed() throws Exception {
        try (var watch = Watch.begin()) {
            var opened = new CountDownLatch(1);
            var dialog = new JDialog[1];
            EventQueue.invokeLater(
                    () -> {
                        dialog[0] = new JDialog();
                        dialog[0].setModal(true);
                        dialog[0].addWindowListener(opening(opened));
                        dialog[0].setVisible(true);
                    });
            opened.await();
            EventQueue.invokeAndWait(() -> {});
            awaitFree(watch);
            EventQueue.invokeAndWait(() -> dialog[0].dispose());
            EventQueue.invokeAndWait(() -> {});
            assertEquals(List.of(), watch.takeFaults());
        }
    }

    private static WindowAdapter opening(CountDownLatch opened) {
        return new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent e) {
                opened.countDown();
            }
        };
    }

    /** Waits until nothing keeps the thread, which otherwise {@link Timeout} ends. */
    private static void awaitFree(Watch watch) throws InterruptedException {
        while (watch.now().isPresent())
            if (Thread.interrupted()) throw new InterruptedException("an event keeps the thread");
    }

    @Test
    void longEventIsPrintedWithItsPlace() throws Exception {
        try (var watch = Watch.begin()) {
            var stays = new ArrayList<LongStay>();
            while (stays.isEmpty()) {
                EventQueue.invokeAndWait(() -> count(new Stay[1]));
                stays.addAll(watch.takeLongStays());
            }
            String text = LongStays.text("Shown", stays);
            assertTrue(text.startsWith("Shown: the event thread was kept for"), text);
            assertTrue(text.contains("EventWatchdogTest.count"), text);
            assertEquals(List.of(), watch.takeFaults());
        }
    }

    /** Counts for longer than an event may last, at work that is none of what is blamed. */
    private static void count(Stay[] sink) {
        var stay = new Stay(new ActionEvent("", 0, ""), Optional.empty());
        while (stay.age() < 4 * Watch.LONG_NANOS) sink[0] = stay;
    }

    @Test
    void longEventLetsItsSourceGo() throws Exception {
        try (var watch = Watch.begin()) {
            var source = new WeakReference<>(postLongEvent());
            EventQueue.invokeAndWait(() -> {}); // The long one has run to its end.
            while (source.get() != null) {
                if (Thread.interrupted()) throw new InterruptedException("the source is held");
                System.gc();
            }
            assertTrue(
                    watch.takeLongStays().stream()
                            .anyMatch(stay -> stay.nanos() > Watch.LONG_NANOS));
        }
    }

    private static Object postLongEvent() {
        var source = new Object();
        Toolkit.getDefaultToolkit()
                .getSystemEventQueue()
                .postEvent(new InvocationEvent(source, () -> count(new Stay[1])));
        return source;
    }

    /** A test of watching runs beside the watch of the whole run. */
    @Test
    void faultGoesToTheNewestWatchAndNotHalfToEach() throws Exception {
        try (var outer = Watch.begin()) {
            for (int round = 0; round < 5; round++) {
                fault(() -> TimeUnit.MILLISECONDS.sleep(5));
                assertEquals(List.of(), outer.takeFaults());
            }
            EventQueue.invokeAndWait(() -> repeat(outer, () -> TimeUnit.MILLISECONDS.sleep(5)));
            assertEquals(1, outer.takeFaults().size(), "of the one that is left");
        }
    }

    /** An event may go on when the test that waited for it has ended. */
    @Test
    void eventOfAnEarlierTestIsNotThisOnes() throws Exception {
        var goesOn = new CountDownLatch(1);
        var begun = new CountDownLatch(1);
        try (var earlier = Watch.begin()) {
            EventQueue.invokeLater(
                    () -> {
                        begun.countDown();
                        while (goesOn.getCount() > 0) count(new Stay[1]);
                    });
            begun.await();
            assertTrue(earlier.now().isPresent());
        }
        try (var watch = Watch.begin()) {
            assertEquals(Optional.empty(), watch.now());
            goesOn.countDown();
            EventQueue.invokeAndWait(() -> {});
            assertEquals(List.of(), watch.takeLongStays());
        }
    }

    @Test
    void testThatBlocksTheEventThreadFailsAndTheNextOnePasses() {
        var failed = new ArrayList<String>();
        var passed = new ArrayList<String>();
        LauncherFactory.create()
                .execute(
                        LauncherDiscoveryRequestBuilder.request()
                                .selectors(selectClass(Blocking.class))
                                .configurationParameter(
                                        "junit.jupiter.extensions.autodetection.enabled", "true")
                                .build(),
                        new TestExecutionListener() {
                            @Override
                            public void executionFinished(
                                    TestIdentifier test, TestExecutionResult result) {
                                if (!test.isTest()) return;
                                boolean good =
                                        result.getStatus() == TestExecutionResult.Status.SUCCESSFUL;
                                (good ? passed : failed).add(test.getDisplayName());
                            }
                        });
        assertEquals(List.of("blocks(Watch)"), failed);
        assertEquals(List.of("isQuick()"), passed);
    }

    /** Run by the test above alone. */
    @ExtendWith(Watching.class)
    static class Blocking {
        @Test
        void blocks(Watch watch) throws Exception {
            EventQueue.invokeAndWait(() -> repeat(watch, () -> TimeUnit.MILLISECONDS.sleep(5)));
        }

        @Test
        void isQuick() throws Exception {
            EventQueue.invokeAndWait(() -> {});
        }
    }

    static final class Watching implements ParameterResolver {
        @Override
        public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
            return parameter.getParameter().getType() == Watch.class;
        }

        @Override
        public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
            return EventWatchdog.watch(context).orElseThrow();
        }
    }
}
