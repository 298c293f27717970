package rasterlab.exercises.runner;

import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import rasterlab.engine.study.NoAnswer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading;
import rasterlab.exercises.predicting.SheetGrading;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Daemons;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.scan.AllowList;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;

/**
 * Grades sources: compiles and runs each in one-shot child processes, compares and scores here.
 *
 * <p>Several threads may grade at once; each grading has children of its own.
 */
public final class Judge implements Grading, AutoCloseable {
    private static final int TRIES = 2;

    /** A time longer than it takes to end a program and to remove a folder. */
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final JudgeSettings settings;
    private final ChildJars jars;
    private final Launcher launcher;
    private volatile Box box;
    private final Children children;
    private final SpeedMemory memory;
    private final Compiling compiling;
    private final Models models = new Models();
    private final AtomicBoolean released = new AtomicBoolean();
    private final Thread atExit;
    private volatile Optional<Thread> making = Optional.empty();

    Judge(
            JudgeSettings settings,
            ChildJars jars,
            Launcher launcher,
            Box box,
            SpeedMemory memory,
            Compiling compiling) {
        this.memory = memory;
        this.compiling = compiling;
        this.settings = settings;
        this.jars = jars;
        this.launcher = launcher;
        this.box = box;
        this.children = new Children(box, launcher, settings.spares());
        this.atExit = new Thread(this::release, "rasterlab-judge-exit");
        Runtime.getRuntime().addShutdownHook(atExit);
    }

    /**
     * Changes with the allow-list, and with a number that whoever changes what this judge says to a
     * source raises by hand.
     */
    public static String version() {
        return "judge-11 " + AllowList.text();
    }

    /**
     * Finds the isolation that works here and prepares children.
     *
     * @throws RuntimeException when no child can be started here; nothing is left behind then
     */
    public static Judge start(JudgeSettings settings) {
        return start(settings, SpeedMemory.ofProcess());
    }

    /**
     * Starts a judge that remembers earlier measurements.
     *
     * @param memory in which bands of speed sources were before
     */
    public static Judge start(JudgeSettings settings, SpeedMemory memory) {
        return start(settings, memory, Compiling::inAChild);
    }

    /** Starts a judge with another compiler than the child, for sources that can do it no harm. */
    static Judge start(JudgeSettings settings, SpeedMemory memory, Compiling compiling) {
        return start(settings, memory, compiling, (launcher, jars) -> false, isolation -> {});
    }

    /**
     * Starts a judge that grades at once: where images of Java have to be made first, children run
     * on the running JDK until they are there.
     *
     * @param changed is told the isolation when it has become another
     */
    public static Judge startAtOnce(
            JudgeSettings settings, SpeedMemory memory, Consumer<Isolation> changed) {
        return start(
                settings,
                memory,
                Compiling::inAChild,
                (launcher, jars) -> ChildJava.isToBeMade(settings, launcher, jars),
                changed);
    }

    private static Judge start(
            JudgeSettings settings,
            SpeedMemory memory,
            Compiling compiling,
            BiPredicate<Launcher, ChildJars> isLater,
            Consumer<Isolation> changed) {
        ChildJars jars = ChildJars.assemble();
        Launcher launcher = new Launcher(jars);
        try {
            boolean later = isLater.test(launcher, jars);
            ChildJava java =
                    later ? ChildJava.untilImages() : ChildJava.found(settings, launcher, jars);
            Box box = BoxChoice.on(launcher, jars, java).choose(settings.box());
            Judge judge = prepared(new Judge(settings, jars, launcher, box, memory, compiling));
            if (later) judge.makeImages(changed);
            return judge;
        } catch (RuntimeException cannotStart) {
            launcher.close();
            jars.close();
            throw cannotStart;
        }
    }

    private static Judge prepared(Judge judge) {
        try {
            judge.children.refill();
            return judge;
        } catch (RuntimeException cannotStart) {
            judge.close();
            throw cannotStart;
        }
    }

    private void makeImages(Consumer<Isolation> changed) {
        Thread maker = Daemons.named("rasterlab-images").newThread(() -> moveToImages(changed));
        making = Optional.of(maker);
        maker.start();
    }

    private void moveToImages(Consumer<Isolation> changed) {
        try {
            ChildJava java = ChildJava.found(settings, launcher, jars);
            Box other = BoxChoice.on(launcher, jars, java).choose(settings.box());
            if (released.get()) return;
            children.moveTo(other);
            box = other;
            changed.accept(other.isolation());
        } catch (RuntimeException failure) {
            if (!released.get())
                System.getLogger(Judge.class.getName())
                        .log(
                                System.Logger.Level.WARNING,
                                "children stay on the running JDK",
                                failure);
        }
    }

    /** The isolation of the student's method on this machine. */
    public Isolation isolation() {
        return box.isolation();
    }

    /** The number of child processes that live now, those in reserve among them. */
    public int livingChildren() {
        return children.living();
    }

    @Override
    public Report grade(
            Exercise exercise, String sent, CaseSelection cases, Consumer<CaseReport> progress)
            throws InterruptedException {
        String source = SourceText.withoutMark(sent);
        ReportSheet sheet = new ReportSheet(exercise, cases, isolation().name());
        Set<String> told = new HashSet<>();
        Consumer<CaseReport> once =
                report -> {
                    if (told.add(report.name())) progress.accept(report);
                };
        if (exercise.predicting().isPresent())
            return new SheetGrading(exercise, cases, once).report(source);
        if (exercise.breaking().isPresent())
            return withRetry(
                    () -> new BreakRun(settings, exercise, launcher, once).run(source), sheet);
        var fault = SourceText.faultOf(source);
        if (fault.isPresent())
            return sheet.rejected(fault.get().verdict(), List.of(fault.get().diagnostic()));
        GradingRun run =
                new GradingRun(settings, exercise, source, cases, once, sheet, memory, models);
        try {
            return withRetry(() -> run.run(children, compiling), sheet);
        } finally {
            children.topUp(ChildKind.values());
        }
    }

    /**
     * Makes a program that can be called from here, input by input, in a child that is kept.
     *
     * @throws NoAnswer when the source does not compile, or has what is not allowed
     */
    public CalledProgram program(Exercise exercise, String sent) throws InterruptedException {
        var made =
                new CalledProgram(
                        settings, exercise, SourceText.withoutMark(sent), children, models);
        made.compile(compiling);
        return made;
    }

    /** One try to grade. */
    private interface Attempt {
        Report report() throws ChildLost, InterruptedException;
    }

    private Report withRetry(Attempt attempt, ReportSheet sheet) throws InterruptedException {
        Message reason = Message.NONE;
        for (int left = TRIES; left > 0; left--) {
            try {
                return attempt.report();
            } catch (ChildLost lost) {
                reason = Message.of("internal.child").and(lost.message());
            } catch (UncheckedIOException cannotStart) {
                reason = Message.of("internal.start", cannotStart.getCause().getMessage());
            }
        }
        return sheet.rejected(GradingVerdict.INTERNAL, List.of(new Diagnostic(0, 0, reason)));
    }

    /**
     * Leaves it to the caller alone to close this judge, also when the program is told to end: what
     * it judges then is not cut off.
     */
    public void closedByCaller() {
        Runtime.getRuntime().removeShutdownHook(atExit);
    }

    /** Ends all children and removes what was prepared for them. */
    @Override
    public void close() {
        if (!release()) return;
        try {
            Runtime.getRuntime().removeShutdownHook(atExit);
        } catch (IllegalStateException programIsEnding) {
            // then the hook runs anyway and finds nothing left to do
            return;
        }
    }

    /** Has an image that is being made given up, and what there is of it removed. */
    private static void stop(Thread maker) {
        maker.interrupt();
        try {
            maker.join(PATIENCE.toMillis());
        } catch (InterruptedException hurried) {
            Thread.currentThread().interrupt();
        }
    }

    /** Releases the child; false when that was done before. */
    private boolean release() {
        if (released.getAndSet(true)) return false;
        making.ifPresent(Judge::stop);
        children.close();
        launcher.close();
        jars.close();
        return true;
    }
}
