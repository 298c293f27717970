package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.score.Phrase;

/** The outcome of a method is told in the language of the reader. */
class MethodsOnInputTest {
    /** Two English words in a row, which no name of a field is. */
    private static final Pattern ENGLISH = Pattern.compile("[a-z]{2,} [a-z]{2,}");

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
        MethodResult tried = onItsHazard(Topics.named(topic), method);
        assertEquals(Verdict.Kind.WRONG, tried.kind());
        assertEquals(said, tried.message().in("ru"));
    }

    @Test
    void aFieldThatTheTopicHasNotIsRefused() {
        String json = "{\"points\":[[1,0]],\"degrees\":90,\"tims\":3}";
        var refused =
                assertThrows(
                        CatalogueException.class,
                        () -> MethodsOnInput.of("rotate", Phrase.quoted("input"), json));
        assertTrue(refused.getMessage().contains("'tims' is not known"), refused.getMessage());
    }

    @Test
    void allFieldsThatAreWrongAreToldEachWithItsPlace() {
        String json = "{\"points\":[[1]],\"degrees\":\"a\",\"tims\":3}";
        var refused =
                assertThrows(
                        CatalogueException.class,
                        () -> MethodsOnInput.of("rotate", Phrase.quoted("input"), json));
        assertEquals(3, refused.all().size(), refused.getMessage());
        for (String place : List.of("'tims'", "/points/0", "'degrees'"))
            assertEquals(
                    1,
                    refused.all().stream().filter(one -> one.in("en").contains(place)).count(),
                    refused.getMessage());
    }

    @Test
    void allFaultsWithinAnArrayAreToldEachWithItsPlace() {
        String json =
                "{\"polygon\":[[0,\"a\"],[1,2],[null,3],4,[5,6,7]],\"rule\":\"evenodd\",\"size\":[3,0]}";
        var refused =
                assertThrows(
                        CatalogueException.class,
                        () -> MethodsOnInput.of("polygon-fill", Phrase.quoted("input"), json));
        assertEquals(5, refused.all().size(), refused.getMessage());
        for (String place :
                List.of("polygon[0][1]", "polygon[2][0]", "polygon[3]", "/polygon/4", "size[1]"))
            assertEquals(
                    1,
                    refused.all().stream().filter(one -> one.in("en").contains(place)).count(),
                    refused.getMessage());
    }

    @Test
    void ofVeryManyFaultsInAnArrayTheirNumberIsTold() {
        String json =
                "{\"polygon\":["
                        + "[true,false],".repeat(15)
                        + "[1,2]],\"rule\":\"evenodd\",\"size\":[3,3]}";
        var refused =
                assertThrows(
                        CatalogueException.class,
                        () -> MethodsOnInput.of("polygon-fill", Phrase.quoted("input"), json));
        assertTrue(refused.getMessage().endsWith("and 18 more mistakes"), refused.getMessage());
    }

    /** The spoilt place: a field, in the first input among a topic's hazards. */
    static Stream<Arguments> spoilt() {
        return Topics.all().stream()
                .flatMap(
                        topic -> {
                            var input = inputOf(topic);
                            var fields = new ArrayList<String>();
                            input.fieldNames().forEachRemaining(fields::add);
                            return fields.stream().map(one -> arguments(topic.name(), one));
                        });
    }

    private static ObjectNode inputOf(Topic<?, ?, ?> topic) {
        return topic.hazards().stream()
                .map(one -> InputJson.of(topic, one.name()))
                .map(one -> one.isArray() ? one.get(0) : one)
                .filter(JsonNode::isObject)
                .map(ObjectNode.class::cast)
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @MethodSource("spoilt")
    void aSpoiltFieldIsRefusedInRussianAlone(String topic, String field) {
        for (String spoilt : List.of("[]", "[[]]", "{}", "\"?\"", "-7")) {
            ObjectNode input = inputOf(Topics.named(topic)).deepCopy();
            input.putRawValue(field, new RawValue(spoilt));
            try {
                MethodsOnInput.of(topic, Phrase.quoted("input"), input.toString());
            } catch (CatalogueException refused) {
                String said = refused.phrase().in("ru");
                assertFalse(ENGLISH.matcher(said).find(), said);
            }
        }
    }

    private static <C> MethodResult onItsHazard(Topic<C, ?, ?> topic, String method) {
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
