package rasterlab.exercises.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;

class StrictJsonTest {
    private static final Field<double[]> POINTS = Field.required("points", Shape.points(2, 1, 3));
    private static final Field<String> RULE =
            Field.optional("rule", Shape.word(List.of("evenodd", "nonzero")));
    private static final Field<Integer> COUNT = Field.optional("count", Shape.whole(1, 9));
    private static final Field<Double> SIZE = Field.optional("size", Shape.number());
    private static final Field<String> NAME =
            Field.optional("name", Shape.text("a name of 1 to 4 letters", 1, 4));
    private static final Field<List<Given>> ITEMS =
            Field.optional("items", Shape.list("objects", Shape.object(POINTS, COUNT), 1, 2));

    @Test
    void readsEachKindOfValue() {
        Given given =
                read(
                        "{\"points\":[[1,2.5],[-0.0,1e-400]],\"rule\":\"nonzero\",\"count\":9,"
                                + "\"size\":-1.5,\"name\":\"abcd\",\"items\":[{\"points\":[[0,0]]}]}");
        assertArrayEquals(new double[] {1, 2.5, -0.0, 0}, given.get(POINTS));
        assertEquals("nonzero", given.find(RULE).orElseThrow());
        assertEquals(9, given.find(COUNT).orElseThrow());
        assertEquals(-1.5, given.find(SIZE).orElseThrow());
        assertEquals("abcd", given.find(NAME).orElseThrow());
        Given item = given.find(ITEMS).orElseThrow().get(0);
        assertArrayEquals(new double[] {0, 0}, item.get(POINTS));
        assertEquals(false, item.find(COUNT).isPresent());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesByPlaceValueAndWhatIsAllowed(String fields, String message) {
        var invalid = assertThrows(InvalidInput.class, () -> read("{" + fields + "}"));
        assertEquals(message, invalid.getMessage());
    }

    static Stream<Arguments> mistakes() {
        String good = "\"points\":[[0,0]],";
        return Stream.of(
                argumentSet(
                        "a point has one coordinate",
                        "\"points\":[[0,0],[1]]",
                        "/points/1: only 1 value; expected an array of 2 numbers"),
                argumentSet(
                        "a list of points is empty",
                        "\"points\":[]",
                        "/points: only 0 values; expected an array of 1 to 3 points of 2 numbers"
                                + " each"),
                argumentSet(
                        "a list of points is too long",
                        "\"points\":[[0,0],[0,0],[0,0],[0,0]]",
                        "/points: more than 3 values; expected an array of 1 to 3 points of 2"
                                + " numbers each"),
                argumentSet(
                        "a coordinate is infinite",
                        "\"points\":[[0,1e400]]",
                        "/points/0/1: expected a number from -1.7976931348623157E308 to"
                                + " 1.7976931348623157E308, got 1e400"),
                argumentSet(
                        "a coordinate is not a number",
                        "\"points\":[[0,NaN]]",
                        "/points/0/1: expected a number from -1.7976931348623157E308 to"
                                + " 1.7976931348623157E308, got NaN"),
                argumentSet(
                        "a word is unknown",
                        good + "\"rule\":\"odd\"",
                        "/rule: expected one of evenodd, nonzero, got the string \"odd\""),
                argumentSet(
                        "a whole number is out of range",
                        good + "\"count\":10",
                        "/count: expected a whole number from 1 to 9, got 10"),
                argumentSet(
                        "a text is too long",
                        good + "\"name\":\"abcde\"",
                        "/name: expected a name of 1 to 4 letters, got the string \"abcde\""),
                argumentSet(
                        "an inner object lacks a field",
                        good + "\"items\":[{\"count\":1}]",
                        "/items/0/points: missing; expected an array of 1 to 3 points of 2 numbers"
                                + " each"),
                argumentSet(
                        "an inner object has an unknown field",
                        good + "\"items\":[{\"size\":1}]",
                        "/items/0/size: unknown field; allowed are count, points"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("broken")
    void aByteThatIsNotUtf8IsNamed(String latin, String refusal) {
        byte[] text = latin.getBytes(StandardCharsets.ISO_8859_1);
        assertEquals(refusal, refusal(text));
    }

    static Stream<Arguments> broken() {
        String far = "{\"name\":" + " ".repeat(20_000);
        return Stream.of(
                argumentSet(
                        "a letter of Latin 1",
                        "{\"name\":\"caf\u00e9\"}",
                        "line 1, column 13: not UTF-8: byte E9 after 12 bytes"),
                argumentSet(
                        "a letter in two bytes where one is enough",
                        "{\"name\":\"\u00c1\u0081\"}",
                        "line 1, column 10: not UTF-8: byte C1 after 9 bytes"),
                argumentSet(
                        "a sign in three bytes where one is enough",
                        "{\n\"name\"\r\n:\"\u00e0\u0080\u00af\"}",
                        "line 3, column 3: not UTF-8: byte E0 after 12 bytes"),
                argumentSet(
                        "half of a surrogate pair",
                        "{\r\"name\":\"\u00ed\u00a0\u0080\"}",
                        "line 2, column 9: not UTF-8: byte ED after 10 bytes"),
                argumentSet(
                        "a character that the text's end cuts",
                        "{\"name\":\"\u00d0",
                        "line 1, column 10: not UTF-8: byte D0 after 9 bytes"),
                argumentSet(
                        "the other sign of a mark of UTF-16",
                        "\u00fe{}",
                        "line 1, column 1: not UTF-8: byte FE after 0 bytes"),
                argumentSet(
                        "far behind what is decoded at once",
                        far + "\u00ff",
                        "line 1, column 20009: not UTF-8: byte FF after 20008 bytes"));
    }

    @Test
    void textInUtf16IsRead() {
        byte[] wide = "{\"name\":\"b\"}".getBytes(StandardCharsets.UTF_16LE);
        assertEquals("b", StrictJson.read(wide, wide.length, List.of(NAME), false).get(NAME));
    }

    private static String refusal(byte[] text) {
        InvalidInput refused =
                assertThrows(
                        InvalidInput.class,
                        () -> StrictJson.read(text, text.length, List.of(NAME), false));
        return refused.getMessage();
    }

    private static Given read(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        return StrictJson.read(
                bytes, bytes.length, List.of(POINTS, RULE, COUNT, SIZE, NAME, ITEMS), false);
    }
}
