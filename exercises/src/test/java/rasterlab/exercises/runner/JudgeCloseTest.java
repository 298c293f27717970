package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

@Tag("slow")
class JudgeCloseTest {
    /**
     * A source that is right on the first case, then endless: only closing the judge can end it in
     * time.
     */
    private static final String ENDLESS_LATER =
            Sources.RIGHT.replace("long dx", "while (x1 == 2 && y1 == 9); long dx");

    @Test
    void aGradingInProgressEndsWithoutAMarkAndWithoutAProcess() throws Exception {
        var before = children();
        var threads = Executors.newSingleThreadExecutor();
        var judging = new CountDownLatch(1);
        var settings = OtherSettings.withCallLimit(Duration.ofMinutes(5), JudgeSettings.defaults());
        var judge = Judge.start(settings);
        try {
            var exercise = Catalogue.builtIn().named("line-bresenham");
            var grading =
                    threads.submit(
                            () ->
                                    judge.grade(
                                            exercise,
                                            ENDLESS_LATER,
                                            CaseSelection.open(),
                                            one -> judging.countDown()));
            assertTrue(judging.await(2, TimeUnit.MINUTES), "first case not judged");
            judge.close();
            assertEquals(Optional.empty(), markOf(grading));
            assertEquals(before, children(), "processes left");
        } finally {
            judge.close();
            threads.shutdownNow();
        }
    }

    /** The verdict for the student: none, where the end is called our fault. */
    private static Optional<GradingVerdict> markOf(Future<Report> grading) throws Exception {
        try {
            var verdict = grading.get(2, TimeUnit.MINUTES).verdict();
            return Optional.of(verdict).filter(one -> one != GradingVerdict.INTERNAL);
        } catch (ExecutionException refused) {
            assertEquals("the judge is closed", refused.getCause().getMessage());
            return Optional.empty();
        }
    }

    private static Set<ProcessHandle> children() {
        return ProcessHandle.current()
                .descendants()
                .filter(ProcessHandle::isAlive)
                .collect(Collectors.toSet());
    }
}
