package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static rasterlab.tests.grading.Solutions.source;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.io.TempDir;

class KillAndRestartTest {
    private static final String EXERCISE = "line-bresenham";
    private static final int SUBMISSIONS = 4;

    /** Each repetition kills at another state: right after the 202, while grading, between two. */
    @RepeatedTest(3)
    void everyAcceptedSubmissionIsGradedOnceAfterTheServerWasKilled(@TempDir Path folder)
            throws Exception {
        var seed = System.nanoTime();
        var data = folder.resolve("course");
        var ids = new ArrayList<String>();
        GraderClient student;
        try (var first = ServerProcess.start(data)) {
            student = GraderClient.of(first.address(), first.token()).joinNewCourse();
            for (var i = 0; i < SUBMISSIONS; i++)
                ids.add(student.submit(EXERCISE, source(Solutions.RIGHT) + "// " + i));
            var waitedFor = new Random(seed).nextInt(SUBMISSIONS);
            for (var i = 0; i < waitedFor; i++) student.result(ids.get(i));
            first.kill();
        }
        try (var second = ServerProcess.start(data)) {
            var again = GraderClient.of(second.address(), student.token());
            var attempts = new ArrayList<Integer>();
            for (var id : ids) {
                var result = again.result(id);
                assertEquals("ok", result.path("verdict").asText(), "seed " + seed + ": " + result);
                attempts.add(result.path("attempt").asInt());
            }
            assertEquals(java.util.List.of(1, 2, 3, 4), attempts, "seed " + seed);
        }
    }
}
