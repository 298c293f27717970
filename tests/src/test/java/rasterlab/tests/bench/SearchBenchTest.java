package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.engine.Topics;
import rasterlab.engine.study.ForwardingTopic;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.tests.bench.language.BenchWords;

class SearchBenchTest {
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();

    private boolean run(Duration longest, Topic<?, ?, ?> topic) {
        var out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        return new SearchBench(longest, new BenchWords(Language.ENGLISH), out)
                .run(List.of(topic), "");
    }

    private List<String> lines() {
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }

    /** The topic with that one of its methods alone. */
    private static <C, I, O> Topic<C, I, O> only(Topic<C, I, O> topic, String method) {
        return new ForwardingTopic<C, I, O>(topic) {
            @Override
            public List<Method<C>> methods() {
                return List.of(topic.method(method));
            }

            @Override
            public List<Mutant<C>> mutants() {
                return List.of();
            }

            @Override
            public List<Mutant<C>> mutants(String answer) {
                return List.of();
            }
        };
    }

    @Test
    void textbookMethodIsFoundToFail() {
        assertTrue(run(Duration.ofMinutes(2), only(Topics.named("color"), "formula-textbook")));
        assertEquals(3, lines().size(), lines().toString());
        assertTrue(lines().get(2).startsWith("color formula-textbook | wrong | "), lines().get(2));
    }

    @Test
    @DisplayName("mutants are not searched, or others than those asked for")
    void mutantIsFoundToFail() {
        var out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        var bench = new SearchBench(Duration.ofMinutes(2), new BenchWords(Language.ENGLISH), out);
        String wanted = "visible-faces turned-away";
        assertTrue(SearchBench.works().contains(wanted));
        assertTrue(bench.run(List.of(Topics.named("visible-faces")), wanted));
        assertEquals(3, lines().size(), lines().toString());
        assertTrue(lines().get(2).startsWith(wanted + " | wrong | "), lines().get(2));
    }

    @Test
    @DisplayName("a failure is searched for of what another method of the topic does rightly")
    void mutantThatIsRightInTheTopicIsNotSearched() {
        List<String> works = SearchBench.works();
        assertFalse(works.contains("shade-face normals-interpolated"), "it is Phong's shading");
        assertTrue(works.contains("shade-face colour-for-vertex"), "a mutant of Gouraud's alone");
        assertEquals(new HashSet<>(works).size(), works.size());
    }

    @Test
    void methodThatPromisesToBeRightIsNot() {
        assertTrue(run(Duration.ofMillis(200), only(Topics.named("color"), "formula")));
        assertTrue(lines().get(2).startsWith("color formula | nothing | - | "), lines().get(2));
    }

    @Test
    @DisplayName("a textbook method that no input was found for passes")
    void whatIsNotFoundIsNotMet() {
        assertFalse(run(Duration.ofNanos(1), only(Topics.named("color"), "formula-textbook")));
        assertTrue(lines().get(2).endsWith(" | no"), lines().get(2));
    }
}
