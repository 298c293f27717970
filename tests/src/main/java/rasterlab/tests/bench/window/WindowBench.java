package rasterlab.tests.bench.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Toolkit;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import javax.swing.RepaintManager;
import javax.swing.SwingUtilities;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.opengl.OpenGlRoom;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.line.Segment;
import rasterlab.tests.bench.language.BenchWords;
import rasterlab.tests.display.DisplayAtRest;

/** The window's goals: its start, frames a second while dragging, memory after long use. */
public final class WindowBench {
    private static final Dimension SIZE = new Dimension(1280, 720);
    private static final double START_GOAL_SECONDS = 2;
    private static final double FRAMES_GOAL = 60;
    private static final double LONGEST_GOAL_MILLIS = 50;
    private static final int COLLECTIONS = 10;

    private static final double GROWTH_GOAL_MEBIBYTES = 10;
    private static final double WARM_UP_SECONDS = 4;

    /**
     * A segment so long that its pixels are shown small, and an end meets another with every move.
     */
    private static final Segment LONG = new Segment(0, 0, 400, 200);

    /** A drag: the tab, the part of it that is taken, and the picture that it changes. */
    private record Work(
            String name, String tab, String grip, Function<LabModels, Object> picture) {}

    private static final List<Work> WORKS =
            List.of(
                    new Work(
                            "turning the vase",
                            "visibility",
                            "stage",
                            models ->
                                    models.of(new VisibilityRoom()).state().picture().orElse(null)),
                    new Work(
                            "dragging a segment's end",
                            "line",
                            "end.B",
                            models -> models.of(new LineRoom()).state().drawings()),
                    new Work(
                            "dragging a clipped segment's end",
                            "clip",
                            "end.B1",
                            models -> models.of(new ClipRoom()).state().results()),
                    new Work(
                            "dragging a control point",
                            "spline",
                            "point.1",
                            models -> models.of(new SplineRoom()).curve().state().drawings()),
                    new Work(
                            "turning OpenGL's scene",
                            "opengl",
                            "opengl.canvas",
                            models -> models.of(new OpenGlRoom()).state().pictures()));

    private final int starts;
    private final double seconds;
    private final int minutes;
    private final BenchWords words;
    private final PrintStream out;
    private final FrameWatch frames = new FrameWatch();
    private final EventWatch events = new EventWatch();
    private final AtomicReference<Throwable> failure = new AtomicReference<>();

    /**
     * @param starts of the lab whose middle one counts, at least 1
     * @param seconds that each thing is dragged
     * @param minutes of use whose growth of memory is measured; 0 for none
     */
    public WindowBench(int starts, double seconds, int minutes, BenchWords words, PrintStream out) {
        this.starts = starts;
        this.seconds = seconds;
        this.minutes = minutes;
        this.words = words;
        this.out = out;
    }

    /** Prints the table; without a display only that there is none. */
    public void run() throws IOException, InterruptedException {
        if (GraphicsEnvironment.isHeadless()) {
            out.println(words.text("no-display"));
            return;
        }
        String size = SIZE.width + "×" + SIZE.height;
        String length = String.format(Locale.ROOT, "%.0f", seconds);
        out.println(words.machine() + words.text("window", size, length) + "\n");
        out.println(words.head("head.window"));
        start();
        try (var folder = new SettingsFolder()) {
            open(folder.settings());
        }
    }

    private void start() throws IOException, InterruptedException {
        var times = new ArrayList<Long>();
        for (int k = 0; k < starts; k++) times.add(StartUp.milliseconds());
        times.sort(null);
        double median = times.get(starts / 2) / 1e3;
        row(
                "start to the first painted tab",
                "%.2f s (%.2f–%.2f)"
                        .formatted(median, times.get(0) / 1e3, times.get(starts - 1) / 1e3),
                "≤ %.0f s".formatted(START_GOAL_SECONDS),
                median <= START_GOAL_SECONDS);
    }

    private void open(Path settings) throws InterruptedException {
        RepaintManager.setCurrentManager(frames);
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(events);
        LabModels models = onEventThread(() -> models());
        LabFrame frame = onEventThread(() -> shown(models, settings));
        try {
            for (Work work : WORKS) drag(frame, models, work);
            if (minutes > 0) use(frame, models);
        } finally {
            onEventThread(
                    () -> {
                        frame.dispose();
                        return null;
                    });
            // The closed window keeps its settings in an event of its own.
            onEventThread(() -> null);
            DisplayAtRest.await();
        }
        if (failure.get() != null)
            throw new IllegalStateException("the lab reported a failure", failure.get());
    }

    private LabModels models() {
        LabTheme.LIGHT.install();
        LabModels models = LabModels.first(failed -> failure.compareAndSet(null, failed));
        models.of(new LineRoom()).show(LONG);
        return models;
    }

    private LabFrame shown(LabModels models, Path settings) {
        var frame =
                new LabFrame(
                        models,
                        LabSettings.first(Language.ENGLISH),
                        Language.ENGLISH,
                        new SettingsFile(settings, out::println),
                        LabsFile.nextTo(settings, out::println),
                        failed -> failure.compareAndSet(null, failed));
        frame.setSize(SIZE);
        frame.setVisible(true);
        return frame;
    }

    private void drag(LabFrame frame, LabModels models, Work work) throws InterruptedException {
        Optional<Drag> gripped = grip(frame, work);
        if (gripped.isEmpty()) {
            out.println(work.name() + " | " + words.text("window.missing", work.grip()) + " | |");
            return;
        }
        Drag drag = gripped.get();
        drag.run(Math.min(WARM_UP_SECONDS, seconds));
        onEventThread(
                () -> {
                    frames.begin(() -> work.picture().apply(models));
                    return events.longest();
                });
        long begun = System.nanoTime();
        drag.run(seconds);
        List<Long> shown = onEventThread(frames::frames);
        double busy = events.longest() / 1e6;
        double perSecond = shown.size() / ((System.nanoTime() - begun) / 1e9);
        row(
                work.name(),
                words.text("window.frames", "%.0f".formatted(perSecond)),
                "≥ %.0f".formatted(FRAMES_GOAL),
                perSecond >= FRAMES_GOAL);
        double longest = longest(begun, shown);
        row(
                work.name() + ", longest frame",
                "%.1f ms".formatted(longest),
                "≤ %.0f ms".formatted(LONGEST_GOAL_MILLIS),
                longest <= LONGEST_GOAL_MILLIS);
        row(
                work.name() + ", longest event",
                "%.1f ms".formatted(busy),
                "≤ %.0f ms".formatted(LONGEST_GOAL_MILLIS),
                busy <= LONGEST_GOAL_MILLIS);
    }

    private static double longest(long begun, List<Long> shown) {
        long longest = 0;
        long last = begun;
        for (long each : shown) {
            longest = Math.max(longest, each - last);
            last = each;
        }
        return longest / 1e6;
    }

    /**
     * Shows the tab, and waits until what it first shows is painted; empty where it lacks the part
     * that is taken, as without OpenGL.
     */
    private Optional<Drag> grip(LabFrame frame, Work work) throws InterruptedException {
        onEventThread(
                () -> {
                    WindowContent.of(frame).show(work.tab());
                    return null;
                });
        while (onEventThread(() -> Drag.named(frame.getContentPane(), work.tab())) == null)
            Thread.onSpinWait();
        var parts = onEventThread(() -> settling(frame.getContentPane()));
        for (Settling part : parts) part.settle();
        onEventThread(() -> null);
        return onEventThread(
                () -> {
                    Component grip = Drag.named(frame.getContentPane(), work.grip());
                    if (grip == null) return Optional.empty();
                    var middle = new Point(grip.getWidth() / 2, grip.getHeight() / 2);
                    // The window tells its light parts of the mouse, not those with own windows.
                    Component told = grip.isLightweight() ? frame : grip;
                    Point place = SwingUtilities.convertPoint(grip, middle, told);
                    return Optional.of(new Drag(told, place, 60));
                });
    }

    /** Uses every tab, each language and theme, and tells what memory it left behind. */
    private void use(LabFrame frame, LabModels models) throws InterruptedException {
        double first = Double.NaN;
        double last = Double.NaN;
        for (int minute = 0; minute <= minutes; minute++) {
            long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
            for (int k = 0; System.nanoTime() < end; k++) {
                int round = k;
                onEventThread(
                        () -> {
                            var look = LabLook.first(Language.values()[round % 2]);
                            frame.wear(look.with(LabTheme.values()[round % 3]));
                            return null;
                        });
                for (Work work : WORKS) {
                    Optional<Drag> drag = grip(frame, work);
                    if (drag.isPresent()) drag.get().run(1);
                }
            }
            last = heldMebibytes();
            if (minute == 0) first = last;
        }
        double growth = last - first;
        row(
                "memory after %d minutes of use beside that after one".formatted(minutes + 1),
                "%+.1f MiB (%.1f → %.1f)".formatted(growth, first, last),
                "± %.0f MiB".formatted(GROWTH_GOAL_MEBIBYTES),
                Math.abs(growth) <= GROWTH_GOAL_MEBIBYTES);
    }

    /**
     * The least that is left after some collections: one does not clear what waits to be finalised,
     * and Java leaves one out while native code holds an array.
     */
    private static double heldMebibytes() throws InterruptedException {
        Runtime runtime = Runtime.getRuntime();
        long least = Long.MAX_VALUE;
        for (int k = 0; k < COLLECTIONS; k++) {
            System.gc();
            least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
            TimeUnit.MILLISECONDS.sleep(100);
        }
        return least / (double) (1 << 20);
    }

    private void row(String work, String figure, String goal, boolean met) {
        out.println(work + " | " + figure + " | " + goal + " | " + words.text(met ? "yes" : "no"));
    }

    /** The parts on the screen that draw in the background. */
    private static List<Settling> settling(Container root) {
        var found = new ArrayList<Settling>();
        for (Component child : root.getComponents()) {
            if (!child.isShowing()) continue;
            if (child instanceof Settling part) found.add(part);
            if (child instanceof Container inner) found.addAll(settling(inner));
        }
        return found;
    }

    private static <T> T onEventThread(Callable<T> work) throws InterruptedException {
        var answer = new AtomicReference<T>();
        var failed = new AtomicReference<Exception>();
        try {
            EventQueue.invokeAndWait(
                    () -> {
                        try {
                            answer.set(work.call());
                        } catch (Exception e) {
                            failed.set(e);
                        }
                    });
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause());
        }
        if (failed.get() != null) throw new IllegalStateException(failed.get());
        return answer.get();
    }
}
