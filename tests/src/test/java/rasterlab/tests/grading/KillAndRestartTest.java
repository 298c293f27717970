package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static rasterlab.tests.grading.Solutions.source;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.grading.CourseDatabase.Standing;

/**
 * A server that is killed leaves work to the next one, which grades what is left, and each once.
 */
@Tag("slow")
class KillAndRestartTest {
    private static final String EXERCISE = "line-bresenham";

    /** A line of the log, which is JSON: what is said, then the id and the verdict to put in. */
    private static final Pattern GRADED =
            Pattern.compile(
                    "\"submission \\{} graded [^\"]*\",\"arguments\":\\s*\\[\"([^\"]+)\",\"([^\"]+)\"");

    /**
     * A source that is right on the first case, then silent until its time is up: seconds in which
     * to kill.
     */
    private static final String SLOW =
            source(Solutions.RIGHT).replace("long dx", "while (x1 == 2 && y1 == 9); long dx");

    private static final String FAST = source(Solutions.RIGHT);

    /**
     * The call that a slow submission is in when the server dies; the fast one behind it waits for
     * its turn.
     */
    enum Moment {
        RUNNING("\"state\":\"running\""),
        BETWEEN_CASES("\"name\":\"last-pixel-is-dropped\""),
        /** The server has all points, and waits to write them down. */
        BEFORE_THE_RESULT_IS_STORED("\"name\":\"speed\"");

        private final String event;

        Moment(String event) {
            this.event = event;
        }
    }

    private final List<String> ids = new ArrayList<>();
    private final Set<String> slow = new HashSet<>();
    private GraderClient student;

    @Test
    void everyAcceptedSubmissionIsGradedOnceWheneverTheServerIsKilled(@TempDir Path folder)
            throws Exception {
        var data = folder.resolve("course");
        for (var moment : Moment.values()) {
            try (var server = ServerProcess.start(data);
                    var database = CourseDatabase.of(data)) {
                if (ids.isEmpty()) joinAndSubmit(server);
                else gradeWhatIsLeft(server);
                assertGradedOnce(data, database);
                slow.add(submit(SLOW));
                submit(FAST);
                await(moment, database);
                server.kill();
                assertLeft(moment, database);
            }
        }
        try (var last = ServerProcess.start(data);
                var database = CourseDatabase.of(data)) {
            gradeWhatIsLeft(last);
            assertGradedOnce(data, database);
        }
    }

    private void joinAndSubmit(ServerProcess first) throws Exception {
        student = GraderClient.of(first.address(), first.token()).joinNewCourse();
        student.result(submit(FAST));
    }

    private void gradeWhatIsLeft(ServerProcess next) throws Exception {
        student = GraderClient.of(next.address(), student.token());
        for (var id : ids) student.result(id);
    }

    private String submit(String source) throws Exception {
        ids.add(student.submit(EXERCISE, source + "// " + ids.size()));
        return ids.get(ids.size() - 1);
    }

    /**
     * Waits for a moment from which on nothing changes in the database, but for what the server has
     * written already.
     */
    private void await(Moment moment, CourseDatabase database) throws Exception {
        var killed = ids.get(ids.size() - 2);
        if (moment == Moment.BEFORE_THE_RESULT_IS_STORED) {
            student.awaitEvent(killed, Moment.BETWEEN_CASES.event);
            database.hold();
        }
        student.awaitEvent(killed, moment.event);
    }

    private void assertLeft(Moment moment, CourseDatabase database) throws Exception {
        int last = ids.size() - 1;
        assertEquals(
                new Standing("running", 1, 0),
                database.standing(ids.get(last - 1)),
                "not killed " + moment);
        assertEquals(
                new Standing("queued", 0, 0), database.standing(ids.get(last)), "killed " + moment);
    }

    private void assertGradedOnce(Path data, CourseDatabase database) throws Exception {
        var expected = new TreeMap<String, List<String>>();
        for (var id : ids) {
            int tries = slow.contains(id) ? 2 : 1;
            assertEquals(new Standing("done", tries, 1), database.standing(id));
            expected.put(id, List.of(slow.contains(id) ? "time_limit" : "ok"));
        }
        assertEquals(expected, gradings(data.resolve("server.log")));
    }

    /** Verdicts by submission, as often as the servers logged them. */
    private static Map<String, List<String>> gradings(Path log) throws IOException {
        var found = new TreeMap<String, List<String>>();
        var line = GRADED.matcher(Files.readString(log));
        while (line.find())
            found.computeIfAbsent(line.group(1), id -> new ArrayList<>()).add(line.group(2));
        return found;
    }
}
