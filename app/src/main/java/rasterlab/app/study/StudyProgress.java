package rasterlab.app.study;

import java.io.PrintStream;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Progress;

/** One line for each tenth of a study's work. */
public final class StudyProgress {
    private final PrintStream err;
    private final Texts texts;
    private int shownTenths;

    public StudyProgress(PrintStream err, Language language) {
        this.err = err;
        texts = Texts.of("study", language);
    }

    public void show(Progress progress) {
        int tenths = 10 * progress.done() / progress.total();
        if (tenths == shownTenths) return;
        shownTenths = tenths;
        err.println(texts.text("progress.workload", 10 * tenths, progress.workload()));
    }
}
