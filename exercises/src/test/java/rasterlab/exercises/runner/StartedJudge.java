package rasterlab.exercises.runner;

import java.nio.file.Path;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.Report;

/**
 * A judge for all tests of a class, whose sources are compiled in this process. No child waits in
 * reserve: one that compiles does a sample first, which costs as much as the source. Children run
 * on images of Java as on a server.
 */
public final class StartedJudge implements BeforeAllCallback, AfterAllCallback {
    /** Images of Java that all tests of the module share, as each takes seconds to make. */
    static final Path IMAGES = Path.of("target", "java-images").toAbsolutePath();

    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");

    private final JudgeSettings settings;
    private WarmCompiler compiler;
    private Judge judge;
    private Judge inChildren;

    StartedJudge() {
        this(JudgeSettings.once());
    }

    /** A judge with other settings. */
    public StartedJudge(JudgeSettings settings) {
        this.settings = settings.withImages(IMAGES);
    }

    @Override
    public void beforeAll(ExtensionContext context) {
        compiler = new WarmCompiler();
        judge = Judge.start(settings, SpeedMemory.ofProcess(), compiler);
    }

    @Override
    public void afterAll(ExtensionContext context) {
        judge.close();
        compiler.close();
        if (inChildren != null) inChildren.close();
        inChildren = null;
    }

    /** The judge while the tests of the class run. */
    public Grading judge() {
        return judge;
    }

    /** The report of a line exercise's open cases on a source. */
    Report grade(String source) throws InterruptedException {
        return grade(source, CaseSelection.open());
    }

    /** The report on a source that is compiled in a child as on the server. */
    Report gradeInChildren(String source) throws InterruptedException {
        if (inChildren == null) inChildren = Judge.start(settings);
        return inChildren.grade(EXERCISE, source, CaseSelection.open(), one -> {});
    }

    Report grade(String source, CaseSelection cases) throws InterruptedException {
        return grade(EXERCISE, source, cases);
    }

    Report grade(Exercise exercise, String source, CaseSelection cases)
            throws InterruptedException {
        return judge.grade(exercise, source, cases, one -> {});
    }
}
