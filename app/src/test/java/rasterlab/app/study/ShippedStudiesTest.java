package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.study.chart.ConditionsWords;
import rasterlab.app.study.chart.LeftOutNote;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.Topics;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.Machine;

class ShippedStudiesTest {
    private static final int MOST_BYTES = 600_000;
    private static final LineTopic LINE = new LineTopic();

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest(name = "no result of {0} ships, or it names no machine")
    @MethodSource("topics")
    void eachTopicHasAResultWithItsMachine(Topic<?, ?, ?> topic) {
        Study study = ShippedStudies.of(topic).orElseThrow();
        Machine where = study.circumstances().orElseThrow().machine();
        String said = new ConditionsWords(Language.ENGLISH).shipped(study);
        assertTrue(study.isWhole(), "stopped before its end");
        for (String part : List.of("comes with", where.processor(), where.java(), "core"))
            assertTrue(said.contains(part), said);
        assertFalse(where.system().contains(" "), where.system());
    }

    /** A method that is newer than the shipped result is told beside it, not left out silently. */
    @ParameterizedTest(name = "a method of {0} is neither measured nor told to be missing")
    @MethodSource("topics")
    void everyMethodIsMeasuredOrToldToBeMissing(Topic<?, ?, ?> topic) {
        Study study = ShippedStudies.of(topic).orElseThrow();
        List<String> told = names(note(study, Language.ENGLISH));
        List<String> measured =
                study.measurements().stream().map(Measurement::method).distinct().toList();
        for (String method : topic.methods().stream().map(Method::name).toList())
            assertTrue(measured.contains(method) || told.contains(method), method);
        assertTrue(2 * measured.size() > topic.methods().size(), "renew it: " + measured);
    }

    @ParameterizedTest(name = "a method that was not measured is not told of in {0}")
    @EnumSource
    void missingMethodIsToldOf(Language language) {
        Study whole = study(List.of(1.0, 2.0));
        String told = note(whole, language);
        assertFalse(names(told).contains("dda"), told);
        assertTrue(names(told).containsAll(List.of("naive", "bresenham")), told);
        String start = language == Language.ENGLISH ? "Not measured yet: " : "Ещё не измерены: ";
        assertTrue(told.startsWith(start), told);
        Study elsewhere =
                new Study(whole.topic(), whole.item(), whole.errorUnit(), whole.measurements());
        assertEquals("", note(elsewhere, language), "figures of elsewhere are not all methods");
    }

    private static List<String> names(String note) {
        return List.of(note.split("[ ,.:]+"));
    }

    private static String note(Study study, Language language) {
        return String.join(" ", LeftOutNote.of(study, new StudyWords(language)).lines());
    }

    @Test
    @DisplayName("the results that ship make the program large")
    void resultsAreShort() throws Exception {
        int bytes = 0;
        for (Topic<?, ?, ?> topic : Topics.all())
            try (InputStream in =
                    ShippedStudies.class.getResourceAsStream("shipped/" + topic.name() + ".json")) {
                bytes += in.readAllBytes().length;
            }
        assertTrue(bytes <= MOST_BYTES, bytes + " bytes");
    }

    private static Study study(List<Double> rounds) {
        var measured =
                new Measurement(
                        "dda",
                        LINE.workloads().get(0).name(),
                        16,
                        Cost.of(rounds, Map.of("items", 16L, "inputs", 2L)),
                        new Deviation(1.0 / 3, 1, 2, 16, "(1, 2)"),
                        Verdict.Kind.DEGRADED,
                        "a detail",
                        List.of(0.25, 1.0 / 3));
        var how =
                new StudyConditions(
                        StudySettings.quick(),
                        Instant.parse("2026-11-28T02:30:00.123Z"),
                        new Machine("Linux 6.1-of-somebody", "Z80", 1, 65_536, "17.0.1"),
                        1.2345,
                        3.5,
                        Map.of(LINE.workloads().get(0).name(), List.of(1.0, 1.1)),
                        true);
        return new Study("line", "pixel", "pixels", List.of(measured), Optional.of(how));
    }

    @Test
    @DisplayName("a shipped result has every round and digit, or the name of a system's build")
    void resultIsShortenedAndReadBack(@TempDir Path folder) throws Exception {
        List<Double> rounds = IntStream.range(1, 46).mapToObj(i -> i + 1.0 / 3).toList();
        Path file = ShippedStudies.write(study(rounds), folder);
        assertEquals("line.json", file.getFileName().toString());
        String json = Files.readString(file, StandardCharsets.UTF_8);
        assertFalse(json.contains("of-somebody") || json.contains("333333"), json);
        Measurement read = StudyReading.of(json, LINE).measurements().get(0);
        assertEquals(15, read.cost().rounds().size());
        assertEquals(1.333, read.cost().rounds().get(0));
        assertEquals(43.33, read.cost().rounds().get(14), "spread over all");
        assertEquals(List.of(0.25, 0.333), read.errors());
        assertEquals("a detail", read.detail());
    }

    @Test
    @DisplayName("a topic that was never measured here has no chart, or one without its origin")
    void tabShowsTheShippedResultUntilAnotherIsThere(@TempDir Path folder) throws Exception {
        var events = new LinkedBlockingQueue<Runnable>();
        var failures = new ArrayList<Throwable>();
        try (var model = new StudyLabModel(List.of(LINE), events::add, failures::add)) {
            assertEquals(Optional.empty(), model.state().study(), "nothing before it is asked for");
            model.keepIn(folder);
            while (model.state().study().isEmpty()) events.poll(1, TimeUnit.MINUTES).run();
            assertEquals(ShippedStudies.of(LINE), model.state().study());
            assertEquals(model.state().study(), model.shippedStudy());
            model.show(study(List.of(1.0)));
            assertEquals(Optional.empty(), model.shippedStudy(), "another was measured");
        }
        assertEquals(List.of(), failures);
    }
}
