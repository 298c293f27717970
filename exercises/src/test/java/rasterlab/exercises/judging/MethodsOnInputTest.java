package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.judging.MethodsOnInput.Tried;
import rasterlab.exercises.score.Phrase;

/** What a method did is told in the language of whoever reads it. */
class MethodsOnInputTest {
    @ParameterizedTest(name = "{0} of {1} is told in another language, or as a crash")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            array-shared      | matrix | при каждом вызове возвращается один и тот же массив, а не новый
            array-shared      | shade  | при каждом вызове возвращается один и тот же массив, а не новый
            array-shared      | color  | при каждом вызове возвращается один и тот же массив, а не новый
            argument-returned | color  | возвращён тот же массив, который был передан, а не новый
            """)
    void anArrayThatIsNotTheCallersOwnIsToldInRussianToo(String method, String topic, String said) {
        Tried tried = onItsHazard(Topics.named(topic), method);
        assertEquals(Verdict.Kind.WRONG, tried.kind());
        assertEquals(said, tried.said().in("ru"));
    }

    private static <C> Tried onItsHazard(Topic<C, ?, ?> topic, String method) {
        String hazard =
                topic.mutants().stream()
                        .filter(one -> one.name().equals(method))
                        .map(Mutant::hazard)
                        .findFirst()
                        .orElseThrow();
        String json = InputJson.of(topic, hazard).toString();
        return MethodsOnInput.of(topic.name(), Phrase.quoted("input"), json)
                .faulty(Set.of(method))
                .get(0);
    }
}
