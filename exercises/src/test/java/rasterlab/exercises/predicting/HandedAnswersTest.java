package rasterlab.exercises.predicting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A sheet that is none is refused with the place, the value and what is allowed. */
class HandedAnswersTest {
    private static HandedAnswers read(String exercise, String json) {
        Exercise named = Catalogue.builtIn().named(exercise);
        return HandedAnswers.of(named, json);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("no JSON", "predict-line", "{", "the sheet is not JSON"),
                argumentSet("an array", "predict-line", "[]", "must be an object"),
                argumentSet("no seed", "predict-line", "{\"answers\":[]}", "'seed' is missing"),
                argumentSet(
                        "seed in quotes",
                        "predict-line",
                        "{\"seed\":\"7\",\"answers\":[]}",
                        "'seed' must be the seed that the sheet came with, a whole number from 0 to"
                                + " 9007199254740991; got \"7\""),
                argumentSet(
                        "seed below 0",
                        "predict-line",
                        "{\"seed\":-1,\"answers\":[]}",
                        "from 0 to 9007199254740991; got -1"),
                argumentSet(
                        "seed too large",
                        "predict-line",
                        "{\"seed\":9007199254740992,\"answers\":[]}",
                        "got 9007199254740992"),
                argumentSet("no answers", "predict-line", "{\"seed\":7}", "'answers' is missing"),
                argumentSet(
                        "another exercise's",
                        "predict-line",
                        "{\"exercise\":\"predict-fill\",\"seed\":7,\"answers\":[]}",
                        "'exercise' must be one of predict-line, got 'predict-fill'"),
                argumentSet(
                        "unknown field",
                        "predict-line",
                        "{\"seed\":7,\"answers\":[{\"z\":1}]}",
                        "field 'answers[0]', field 'z' is not known"),
                argumentSet(
                        "word for a number",
                        "predict-line",
                        "{\"seed\":7,\"answers\":[{\"x\":1,\"y\":2},{\"x\":\"a\"}]}",
                        "'answers[1]', field 'x' must be a number, or null for no answer; got"
                                + " \"a\""),
                argumentSet(
                        "answers out of order",
                        "predict-line",
                        "{\"seed\":7,\"answers\":[{\"question\":2}]}",
                        "'answers[0]', field 'question' must be 1, got 2"),
                argumentSet(
                        "side that is none",
                        "predict-clip-segment",
                        "{\"seed\":7,\"answers\":[{\"at\":\"above\"}]}",
                        "must be one of left, right, bottom, top, got 'above'"),
                argumentSet(
                        "array too short",
                        "predict-vertex-normals",
                        "{\"seed\":7,\"answers\":[{\"sum\":[1,2]}]}",
                        "must have numbers as [0, 0, 0] has them"),
                argumentSet(
                        "number for yes or no",
                        "predict-visible-faces",
                        "{\"seed\":7,\"answers\":[{\"visible\":1}]}",
                        "must be true or false, got 1"),
                argumentSet(
                        "too many",
                        "predict-line",
                        "{\"seed\":7,\"answers\":[" + "{},".repeat(16) + "{}]}",
                        "has 17 answers; the sheet asks for 16"),
                argumentSet(
                        "too long",
                        "predict-line",
                        " ".repeat(64 * 1024) + "{}",
                        "the file has 65538 characters"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void isRefusedWithItsPlace(String exercise, String json, String said) {
        CatalogueException refused =
                assertThrows(CatalogueException.class, () -> read(exercise, json));
        assertTrue(refused.getMessage().contains(said), refused.getMessage());
        assertTrue(!refused.in("ru").equals(refused.in("en")), refused.in("ru"));
    }

    @Test
    void allMistakesAreToldAtOnceEachWithItsPlace() {
        String json =
                "{\"exercise\":\"predict-clip-segment\",\"seed\":7,\"extra\":1,\"answers\":["
                        + "{\"question\":2,\"decision\":\"a\"},{\"at\":\"above\",\"z\":1}]}";
        CatalogueException refused =
                assertThrows(CatalogueException.class, () -> read("predict-clip-segment", json));
        assertEquals(
                List.of("extra", "question", "decision", "z", "at").stream().sorted().toList(),
                refused.all().stream()
                        .map(one -> one.in("en").replaceAll("^.*field '(\\w+)' .*$", "$1"))
                        .sorted()
                        .toList(),
                refused.getMessage());
        assertTrue(refused.in("ru").contains("above"), refused.in("ru"));
        assertTrue(refused.in("ru").contains("«extra»"), refused.in("ru"));
    }

    @Test
    void eachAnswerThatIsNoObjectIsTold() {
        String json = "{\"seed\":7,\"answers\":[3,{\"x\":\"a\"},[],{\"x\":1,\"y\":2}]}";
        CatalogueException refused =
                assertThrows(CatalogueException.class, () -> read("predict-line", json));
        assertEquals(3, refused.all().size(), refused.getMessage());
        for (String place : List.of("'answers[0]'", "'answers[1]'", "'answers[2]'"))
            assertTrue(refused.getMessage().contains(place), refused.getMessage());
    }

    @Test
    void ofVeryManyMistakesTheirNumberIsTold() {
        String json =
                "{\"seed\":7,\"answers\":[" + "{\"x\":\"a\",\"y\":\"b\"},".repeat(15) + "{}]}";
        CatalogueException refused =
                assertThrows(CatalogueException.class, () -> read("predict-line", json));
        assertEquals(13, refused.all().size());
        assertTrue(refused.getMessage().endsWith("and 18 more mistakes"), refused.getMessage());
        assertTrue(refused.in("ru").endsWith("и ещё 18 ошибок"), refused.in("ru"));
    }

    @Test
    void answersAreReadAlsoWhereTheSeedIsWrong() {
        String json = "{\"seed\":-1,\"answers\":[{\"at\":\"above\"}]}";
        CatalogueException refused =
                assertThrows(CatalogueException.class, () -> read("predict-clip-segment", json));
        assertEquals(2, refused.all().size(), refused.getMessage());
    }

    @Test
    void whatIsLeftOutIsNotAnswered() {
        HandedAnswers read = read("predict-line", "{\"seed\":7,\"answers\":[{\"x\":null}]}");
        assertEquals(16, read.answers().size());
        assertTrue(read.sheet().questions().get(0).isOpen(read.answers().get(0)));
        assertTrue(read.sheet().questions().get(15).isOpen(read.answers().get(15)));
    }
}
