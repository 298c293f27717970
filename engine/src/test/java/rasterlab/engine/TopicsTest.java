package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.Workload;

/** Checks rules that hold for every topic, whatever it is about. */
class TopicsTest {
    private static final Duration AMPLE = Duration.ofMinutes(2);

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    /** The method × hazard table, worked out once for all tests of it. */
    private static final Map<String, List<VerdictCell>> TABLES = new LinkedHashMap<>();

    @BeforeAll
    static void workOutTheTable() {
        for (Topic<?, ?, ?> topic : Topics.all())
            TABLES.put(topic.name(), HazardTrial.table(topic, AMPLE));
    }

    @AfterAll
    static void forgetTheTable() {
        TABLES.clear();
    }

    static Stream<VerdictCell> cells() {
        return TABLES.values().stream().flatMap(List::stream);
    }

    @ParameterizedTest
    @MethodSource("topics")
    @EnabledOnOs(
            architectures = {"amd64", "x86_64"},
            disabledReason = "the last bits of sines and cosines differ between processors")
    void everyVerdictSaysWhatItSaidBefore(Topic<?, ?, ?> topic) throws IOException {
        new GoldenVerdicts(topic.name()).assertHold(TABLES.get(topic.name()));
    }

    @ParameterizedTest
    @MethodSource("cells")
    void everyVerdictIsTheRecordedOneAndSaysInOneLineWhatHappened(VerdictCell cell) {
        assertEquals(cell.recorded(), cell.verdict().kind(), cell.toString());
        String detail = cell.verdict().detail();
        assertTrue(detail.lines().count() <= 1, detail);
        if (cell.verdict().kind() != Verdict.Kind.EXACT)
            assertFalse(detail.isEmpty(), cell.hazard());
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyHazardRecordsEveryMethod(Topic<?, ?, ?> topic) {
        Set<String> names = names(topic.methods());
        for (var hazard : topic.hazards())
            assertEquals(names, new TreeSet<>(hazard.recorded().keySet()), hazard.name());
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyTextbookMethodFailsOnSomeHazard(Topic<?, ?, ?> topic) {
        for (Method<?> method : topic.methods())
            if (method.faulty())
                assertTrue(
                        topic.hazards().stream()
                                .map(hazard -> hazard.recorded().get(method.name()))
                                .anyMatch(kind -> kind.compareTo(Verdict.Kind.DEGRADED) >= 0),
                        method.name());
    }

    @ParameterizedTest
    @MethodSource("topics")
    void someMethodIsRightOnEveryHazardItDoesNotRefuse(Topic<?, ?, ?> topic) {
        assertTrue(
                topic.methods().stream()
                        .anyMatch(
                                method ->
                                        topic.hazards().stream()
                                                .map(h -> h.recorded().get(method.name()))
                                                .allMatch(TopicsTest::harmless)),
                topic.name());
    }

    private static boolean harmless(Verdict.Kind kind) {
        return kind == Verdict.Kind.EXACT || kind == Verdict.Kind.REFUSED;
    }

    @ParameterizedTest
    @MethodSource("topics")
    void workloadsGrowAndNoNameStandsTwice(Topic<?, ?, ?> topic) {
        List<Integer> sizes = topic.workloads().stream().map(w -> w.size()).toList();
        assertEquals(sizes.stream().sorted().toList(), sizes, topic.name());
        assertUnique(topic.workloads().stream().map(Workload::name));
        assertUnique(topic.methods().stream().map(Method::name));
        assertUnique(topic.hazards().stream().map(hazard -> hazard.name()));
    }

    @Test
    void noTwoTopicsHaveOneName() {
        assertUnique(topics().map(Topic::name));
    }

    private static void assertUnique(Stream<String> names) {
        var seen = new HashSet<String>();
        names.forEach(name -> assertTrue(seen.add(name), name + " stands twice"));
    }

    private static Set<String> names(List<? extends Method<?>> methods) {
        return methods.stream().map(Method::name).collect(Collectors.toCollection(TreeSet::new));
    }
}
