package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class KotlinFunctionsTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void countsFromTheFirstLineToTheLast(List<Integer> lines, String source) {
        var found = KotlinFunctions.of("A.kt", source).stream().map(SourceFunction::lines).toList();
        assertEquals(lines, found);
    }

    static Stream<Arguments> mistakes() {
        var modifiers =
                "class A {\n    override suspend fun <T> List<T>.a(b: T) {\n        c()\n    }\n}";
        var parameters = "fun a(\n    b: Int,\n) {\n    c()\n}\n\nval d = 1";
        var gap = "fun a() {\n    b()\n\n    c()\n}\n\n// later\nfun d() = 2";
        var expression = "fun a() =\n    b()\n        .c()\n\n/** d */\nval d = 1";
        var nested = "fun a() {\n    fun b() {\n        c()\n    }\n}";
        return Stream.of(
                argumentSet("one line counts as none", List.of(1), "fun a() = 1\n"),
                argumentSet("modifiers and receivers hide a function", List.of(3), modifiers),
                argumentSet("parameters on lines of their own end it", List.of(5), parameters),
                argumentSet("an empty line ends it, or a comment joins it", List.of(5, 1), gap),
                argumentSet("an expression has no end", List.of(3), expression),
                argumentSet("a function in a function ends it", List.of(5, 3), nested),
                argumentSet("a word with fun in it is one", List.of(), "val funny = 1\n"));
    }
}
