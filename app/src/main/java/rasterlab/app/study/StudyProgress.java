package rasterlab.app.study;

import java.io.PrintStream;
import rasterlab.engine.study.Progress;

/** One line for each tenth of a study's work. */
public final class StudyProgress {
    private final PrintStream err;
    private int shownTenths;

    public StudyProgress(PrintStream err) {
        this.err = err;
    }

    public void show(Progress progress) {
        int tenths = 10 * progress.done() / progress.total();
        if (tenths == shownTenths) return;
        shownTenths = tenths;
        err.println(10 * tenths + " % measured, now at workload " + progress.workload());
    }
}
