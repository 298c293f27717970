package rasterlab.exercises.runner.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Where the word "exit" stands in a source: line and column of each. */
class SourceWordsTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("sources")
    void readsWordsOnlyInCode(String source, List<String> places) {
        List<String> found = new ArrayList<>();
        SourceWords words = new SourceWords(source);
        while (words.next()) if (words.is("exit")) found.add(words.line() + ":" + words.column());
        assertEquals(places, found);
    }

    static Stream<Arguments> sources() {
        return Stream.of(
                argumentSet(
                        "a word in a comment counts", "/* exit */ // exit\nexit", List.of("2:1")),
                argumentSet("a comment ends at a slash", "/*/ exit */ exit", List.of("1:13")),
                argumentSet(
                        "any star before a slash ends a comment",
                        "/* * / exit */ exit",
                        List.of("1:16")),
                argumentSet("two stars hide a comment's end", "/***/ exit", List.of("1:7")),
                argumentSet("a comment sign in a string begins one", "\"/*\" exit", List.of("1:6")),
                argumentSet(
                        "a quote in a comment begins a string", "/* \" */ exit", List.of("1:9")),
                argumentSet("an escaped quote ends a string", "\"\\\" exit\" a", List.of()),
                argumentSet("two backslashes escape a quote", "\"\\\\\" exit", List.of("1:6")),
                argumentSet("a quote as a character begins a string", "'\"' exit", List.of("1:5")),
                argumentSet("an open string takes the next line", "\" a\nexit", List.of("2:1")),
                argumentSet(
                        "quotes in a text block end it",
                        "\"\"\"\n a \" exit \\\"\"\" exit\n\"\"\" exit",
                        List.of("3:5")),
                argumentSet("a carriage return is no line's end", "\r\n\r\rexit", List.of("4:1")),
                argumentSet(
                        "an escaped letter is no letter",
                        "\\u0065xit ex\\uu0069t",
                        List.of("1:1", "1:11")),
                argumentSet(
                        "an escaped sign begins no comment",
                        "\\u002f* exit */ exit",
                        List.of("1:17")),
                argumentSet(
                        "a backslash before an escape", "\"\\\\u0022 exit\" exit", List.of("1:16")),
                argumentSet("an escaped line end is counted", "// \\u000a exit", List.of("1:11")),
                argumentSet("a part of a word is one", "exits exit1 exit$ 1exit _exit", List.of()),
                argumentSet("letters of other scripts end a word", "выexit exitы", List.of()),
                argumentSet("a number's letters are a word", "0xexit 1e exit", List.of("1:11")),
                argumentSet("a comment without end", "exit /* exit", List.of("1:1")),
                argumentSet("an escape without end", "exit \\u00", List.of("1:1")),
                argumentSet("an empty source", "", List.of()));
    }
}
