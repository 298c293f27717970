package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static rasterlab.tests.grading.Solutions.source;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.tests.grading.CourseDatabase.Standing;

/** Whatever a server that is killed was doing, the next one grades what is left, and each once. */
class KillAndRestartTest {
    private static final String EXERCISE = "line-bresenham";

    /** A line of the log, which is JSON: what is said, then the id and the verdict to put in. */
    private static final Pattern GRADED =
            Pattern.compile(
                    "\"submission \\{} graded [^\"]*\",\"arguments\":\\s*\\[\"([^\"]+)\",\"([^\"]+)\"");

    /** Right on the first case, then silent until its time is up: seconds in which to kill. */
    private static final String SLOW =
            source(Solutions.RIGHT).replace("long dx", "while (x1 == 2 && y1 == 9); long dx");

    private static final String FAST = source(Solutions.RIGHT);

    /** What happens to the slow submission, and to the fast one behind it, when the server dies. */
    enum Moment {
        QUEUED("", "queued", 0),
        RUNNING("\"state\":\"running\"", "running", 1),
        BETWEEN_CASES("\"name\":\"last-pixel-is-dropped\"", "running", 1),
        /** The server has all points, and waits to write them down. */
        BEFORE_THE_RESULT_IS_STORED("\"name\":\"speed\"", "running", 1);

        private final String event;
        private final Standing left;

        Moment(String event, String state, int tries) {
            this.event = event;
            this.left = new Standing(state, tries, 0);
        }
    }

    private final List<String> ids = new ArrayList<>();
    private GraderClient student;

    @ParameterizedTest(name = "killed while {0}, a submission is lost or graded twice")
    @EnumSource
    void everyAcceptedSubmissionIsGradedOnce(Moment moment, @TempDir Path folder) throws Exception {
        var data = folder.resolve("course");
        try (var first = ServerProcess.start(data);
                var database = CourseDatabase.of(data)) {
            student = GraderClient.of(first.address(), first.token()).joinNewCourse();
            submit(FAST);
            student.result(ids.get(0));
            submit(SLOW);
            submit(FAST);
            await(moment, database);
            first.kill();
            assertLeft(moment, database);
        }
        try (var second = ServerProcess.start(data)) {
            student = GraderClient.of(second.address(), student.token());
            for (var id : ids) student.result(id);
        }
        assertGradedOnce(moment, data);
    }

    private void submit(String source) throws Exception {
        ids.add(student.submit(EXERCISE, source + "// " + ids.size()));
    }

    /**
     * From here on nothing changes in the database, but for what the server has written already.
     */
    private void await(Moment moment, CourseDatabase database) throws Exception {
        if (moment == Moment.BEFORE_THE_RESULT_IS_STORED) {
            student.awaitEvent(ids.get(1), Moment.BETWEEN_CASES.event);
            database.hold();
        }
        if (!moment.event.isEmpty()) student.awaitEvent(ids.get(1), moment.event);
    }

    private void assertLeft(Moment moment, CourseDatabase database) throws Exception {
        assertEquals(new Standing("done", 1, 1), database.standing(ids.get(0)));
        var killed = ids.get(moment == Moment.QUEUED ? 2 : 1);
        assertEquals(moment.left, database.standing(killed), "not killed at the wanted moment");
    }

    private void assertGradedOnce(Moment moment, Path data) throws Exception {
        try (var database = CourseDatabase.of(data)) {
            assertEquals(new Standing("done", 1, 1), database.standing(ids.get(0)));
            assertEquals(new Standing("done", 1, 1), database.standing(ids.get(2)));
            var again = database.standing(ids.get(1));
            assertEquals("done", again.state());
            assertEquals(1, again.results());
            if (moment != Moment.QUEUED) assertEquals(2, again.tries());
        }
        var expected = new TreeMap<String, List<String>>();
        for (var id : ids) expected.put(id, List.of(id.equals(ids.get(1)) ? "time_limit" : "ok"));
        assertEquals(expected, gradings(data.resolve("server.log")));
    }

    /** Verdicts by submission, as often as the two servers logged them. */
    private static Map<String, List<String>> gradings(Path log) throws IOException {
        var found = new TreeMap<String, List<String>>();
        var line = GRADED.matcher(Files.readString(log));
        while (line.find())
            found.computeIfAbsent(line.group(1), id -> new ArrayList<>()).add(line.group(2));
        return found;
    }
}
