package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.study.Topic;

class TopicListTest {
    static List<Topic<?, ?, ?>> topics() {
        return Topics.all();
    }

    @Test
    void eachTopicIsListedOnceByItsOwnName() {
        List<String> names = Topics.names();
        assertEquals(names, topics().stream().map(Topic::name).toList());
        assertEquals(names.size(), new HashSet<>(names).size());
    }

    @Test
    void anUnknownTopicIsRefusedWithTheNamesOfAll() {
        String said =
                assertThrows(IllegalArgumentException.class, () -> Topics.named("")).getMessage();
        assertTrue(said.endsWith("there are " + String.join(", ", Topics.names())), said);
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyMethodAndMutantIsOfTheTopicsContract(Topic<?, ?, ?> topic) {
        for (var method : topic.methods())
            assertTrue(topic.contract().isInstance(method.implementation()), method.name());
        for (var mutant : topic.mutants())
            assertTrue(topic.contract().isInstance(mutant.implementation()), mutant.name());
    }
}
