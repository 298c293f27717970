package rasterlab.app.study.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

class WorkloadWordsTest {
    private static final Pattern PLAIN_NUMBER = Pattern.compile("[\\d⁰¹²³⁴⁵⁶⁷⁸⁹]+");

    @ParameterizedTest(name = "a workload, or what its size counts, is not said in {0}")
    @EnumSource
    void everyWorkloadAndItsSizeHaveWords(Language language) {
        var words = new WorkloadWords(Texts.of("study", language));
        var unsaid = new TreeSet<String>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Workload<?> workload : topic.workloads()) {
                String size = words.size(topic.name(), workload.name(), workload.size());
                if (words.workload(topic.name(), workload.name()).equals(workload.name())
                        || PLAIN_NUMBER.matcher(size).matches())
                    unsaid.add(topic.name() + " " + workload.name());
            }
        assertEquals(new TreeSet<>(), unsaid);
    }

    @ParameterizedTest(name = "two workloads of a topic are one in {0}")
    @EnumSource
    void workloadsOfATopicDiffer(Language language) {
        var words = new WorkloadWords(Texts.of("study", language));
        for (Topic<?, ?, ?> topic : Topics.all()) {
            var said = new TreeSet<String>();
            for (Workload<?> workload : topic.workloads())
                assertTrue(
                        said.add(words.workload(topic.name(), workload.name())),
                        topic.name() + " " + workload.name());
        }
    }

    @Test
    @DisplayName("a size has another unit or form than its number asks for")
    void sizesSayWhatTheyCount() {
        var english = new WorkloadWords(Texts.of("study", Language.ENGLISH));
        assertEquals("4096 px", english.size("line", "length-4096", 4096));
        assertEquals("r = 16", english.size("circle", "radius-16", 16));
        assertEquals("a = 16", english.size("ellipse", "radius-16", 16));
        assertEquals("1 point", english.size("view", "points-1", 1));
        assertEquals("16 points", english.size("point-in-triangle", "pixels-16", 16));
        assertEquals("10⁷ turns", english.size("rotate", "turns-10000000", 10_000_000));
        assertEquals("64×64", english.size("polygon-fill", "side-64-corners-20", 4096));
        assertEquals("≤ 1/64 px", english.size("curve", "flat-64th-px", 160));
        var russian = new WorkloadWords(Texts.of("study", Language.RUSSIAN));
        assertEquals("256 вершин", russian.size("triangulate", "star-256", 256));
        assertEquals("64 вершины", russian.size("triangulate", "star-64", 64));
        assertEquals(
                "вершин 20, изображение 64×64",
                russian.workload("polygon-fill", "side-64-corners-20"));
    }

    @Test
    @DisplayName("the digits of a large workload run together")
    void largeNumbersAreGrouped() {
        var english = new WorkloadWords(Texts.of("study", Language.ENGLISH));
        assertEquals("10,000,000 turns of a point", english.workload("rotate", "turns-10000000"));
        assertEquals("9999 turns of a point", english.workload("rotate", "turns-9999"));
        var russian = new WorkloadWords(Texts.of("study", Language.RUSSIAN));
        assertEquals("10\u00a0000 поворотов точки", russian.workload("rotate", "turns-10000"));
    }

    @Test
    @DisplayName("a workload that has no words is not shown at all")
    void unknownWorkloadsKeepTheirName() {
        var english = new WorkloadWords(Texts.of("study", Language.ENGLISH));
        assertEquals("own-8", english.workload("line", "own-8"));
        assertEquals("8", english.size("line", "own-8", 8));
    }
}
