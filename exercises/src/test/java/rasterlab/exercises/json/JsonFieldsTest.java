package rasterlab.exercises.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.CatalogueException;

/** A text that is not JSON is answered with a place in it and a reason, nothing of the parser's. */
class JsonFieldsTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void isNamed(String json, String said) {
        var e = assertThrows(CatalogueException.class, () -> JsonFields.parse("a.json", json));
        assertEquals("a.json " + said, e.getMessage());
        assertFalse(e.in("ru").matches("(?s).*[a-z]{2,} [a-z]{2,}.*"), e.in("ru"));
    }

    static Stream<Arguments> mistakes() {
        String open = "the text ends here, but something in it is not closed";
        return Stream.of(
                argumentSet("object is not closed", "{", "is not JSON: line 1, column 2: " + open),
                argumentSet(
                        "text is not closed",
                        "{\n\"a\": \"b",
                        "is not JSON: line 2, column 8: " + open),
                argumentSet(
                        "wrong bracket",
                        "{\"a\": [1}",
                        "is not JSON: line 1, column 9: Unexpected close marker '}': expected ']'"),
                argumentSet(
                        "second value",
                        "{} []",
                        "is not JSON: line 1, column 4: the value ends here, but something follows it"),
                argumentSet(
                        "field twice",
                        "{\"a\": 1,\n\"a\": 2}",
                        "is not JSON: line 2, column 4: Duplicate field 'a'"),
                argumentSet(
                        "nested too deep",
                        "[".repeat(1500),
                        "is not JSON: Document nesting depth (1001) exceeds the maximum allowed"
                                + " (1000)"),
                argumentSet(
                        "number too long",
                        "{\"a\": " + "1".repeat(2000) + "}",
                        "is not JSON: Number value length (2000) exceeds the maximum allowed (1000)"),
                argumentSet("nothing", "", "must be an object {…}, got nothing"));
    }
}
