package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class WrappingTest {
    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "line is longer than its room",
                        "a bc def g",
                        4,
                        List.of("a bc", "def", "g")),
                argumentSet(
                        "long word goes on beyond the room",
                        "is 1234567",
                        4,
                        List.of("is", "1234", "567")),
                argumentSet(
                        "word is not broken at its hyphen", "one-way", 5, List.of("one-", "way")),
                argumentSet("minus is torn from its number", "-12345", 4, List.of("-123", "45")),
                argumentSet(
                        "words after a long one are lost",
                        "12345 a b",
                        4,
                        List.of("1234", "5 a", "b")),
                argumentSet("no room loops for ever", "abc", 0, List.of("a", "b", "c")),
                argumentSet("nothing is no line", "", 4, List.of("")));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void breaksBetweenWordsAndWithinLongOnes(String sentence, int room, List<String> lines) {
        assertEquals(lines, Wrapping.lines(sentence, room, String::length));
    }
}
