package rasterlab.tests.bench.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.Ranking;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;

class StudyRunTest {
    private static StudyRun run(String pairs, double nanosOfA) throws Exception {
        return StudyRun.of(
                new ObjectMapper()
                        .readTree(
                                """
                                {"comparisons": [%s], "measurements": [
                                {"workload": "w", "method": "a", "nanosPerItem": {"median": %s}},
                                {"workload": "w", "method": "b", "nanosPerItem": null}]}
                                """
                                        .formatted(pairs, nanosOfA)));
    }

    private static String pair(String method, String other, String order) {
        return "{\"workload\": \"w\", \"method\": \"%s\", \"other\": \"%s\", \"order\": \"%s\"}"
                .formatted(method, other, order);
    }

    private static String pairs(String... pairs) {
        return String.join(",", List.of(pairs));
    }

    @Test
    @DisplayName("pairs that only one run tells apart count, or an opposite order does not")
    void onlyPairsThatBothTellApartCount() throws Exception {
        StudyRun one =
                run(
                        pairs(
                                pair("a", "b", "faster"),
                                pair("a", "c", "faster"),
                                pair("b", "c", "open")),
                        1);
        StudyRun other =
                run(
                        pairs(
                                pair("b", "a", "faster"),
                                pair("a", "c", "faster"),
                                pair("b", "c", "faster")),
                        1);
        assertEquals(2, one.bothTold(other));
        assertEquals(1, one.opposed(other));
        assertEquals(0, one.tau(other));
        assertEquals(3, one.pairs());
    }

    @Test
    @DisplayName("a median that is 16 % larger, or one that was not timed, is near")
    void mediansAreNearWithin15Percent() throws Exception {
        assertEquals(1, run("", 100).near(run("", 114)));
        assertEquals(0, run("", 100).near(run("", 116)));
        assertEquals(0, run("", 116).near(run("", 100)));
    }

    @Test
    @DisplayName("the slowed method is judged wrong, or is one method twice")
    void slowedMethodIsRightAndTimed() {
        Study study =
                StudyRunner.measure(
                        new SlowedLines("bresenham"),
                        StudySettings.shortest(),
                        step -> {},
                        () -> false);
        for (Ranking ranking : Ranking.all(study)) assertEquals(2, ranking.places().size());
        assertTrue(study.measurements().stream().allMatch(one -> one.error().worst() == 0));
    }
}
