package rasterlab.exercises.topic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.graded.TopicPart;

class TopicGradingsTest {
    static List<TopicGrading> own() {
        return TopicGradings.own();
    }

    static List<String> names() {
        return TopicGradings.names();
    }

    @ParameterizedTest
    @MethodSource("own")
    void aGradingOfItsOwnIsFoundByTheNameOfItsTopic(TopicGrading own) {
        assertTrue(names().contains(own.name()), own.name());
        assertSame(own.getClass(), TopicGradings.named(own.name()).getClass());
    }

    @Test
    void allTopicsOfAContractForStudentsCanBeGraded() {
        var rest = new ArrayList<>(Topics.names());
        rest.removeAll(names());
        assertEquals(List.of("hidden-surfaces"), rest);
        String said =
                assertThrows(
                                IllegalArgumentException.class,
                                () -> TopicGradings.named("hidden-surfaces"))
                        .getMessage();
        assertEquals(
                "no topic 'hidden-surfaces' can be graded; there are " + String.join(", ", names()),
                said);
    }

    @ParameterizedTest
    @MethodSource("names")
    void aStudentImplementsTheContractThatTheTopicsMethodsDo(String name) {
        Topic<?, ?, ?> topic = Topics.named(name);
        Class<?> contract = TopicGradings.named(name).contract();
        assertSame(topic.contract(), contract);
        for (var method : topic.methods())
            assertTrue(contract.isInstance(method.implementation()), method.name());
    }

    /** A part is told by its contract, and found by that of its topic. */
    @Test
    void noTwoTopicsAndPartsHaveOneContract() {
        List<Class<?>> all = TopicGradings.contracts();
        assertEquals(new HashSet<>(all).size(), all.size());
        assertEquals(names().size() + TopicPart.all().size(), all.size());
    }

    @Test
    void partsBelongToTheTopicOfTheirFullContract() {
        assertEquals(List.of("CurveEvaluator", "CurveFlattener"), TopicGradings.parts("curve"));
        assertEquals(List.of("WindowedLineRasterizer"), TopicGradings.parts("line"));
        assertEquals(List.of(), TopicGradings.parts("circle"));
    }
}
