package rasterlab.exercises.runner;

import java.util.function.Consumer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Report;

/**
 * Grades sources: compiles and runs each in one-shot child processes, compares and scores here.
 *
 * <p>Several threads may grade at once; each grading has children of its own.
 */
public final class Judge implements Grading, AutoCloseable {
    private final JudgeSettings settings;
    private final Isolation isolation;

    private Judge(JudgeSettings settings, Isolation isolation) {
        this.settings = settings;
        this.isolation = isolation;
    }

    /** Changes with every change of the judge that can change a grade. */
    public static String version() {
        return "judge-1";
    }

    /** Looks for the isolation that works here and prepares the children. */
    public static Judge start(JudgeSettings settings) {
        return new Judge(settings, Isolation.processLimits("not looked for"));
    }

    /** What shuts the student's method in on this machine. */
    public Isolation isolation() {
        return isolation;
    }

    @Override
    public Report grade(
            Exercise exercise, String source, CaseSelection cases, Consumer<CaseReport> progress)
            throws InterruptedException {
        throw new UnsupportedOperationException("the runner is being built: " + settings);
    }

    /** Ends all children. */
    @Override
    public void close() {}
}
