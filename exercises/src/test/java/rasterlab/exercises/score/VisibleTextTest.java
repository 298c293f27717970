package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A report has nothing that acts on the terminal or hides on the page. */
class VisibleTextTest {
    static Stream<Arguments> texts() {
        return Stream.of(
                argumentSet("terminal is recoloured", "\u001B[31mok\u0007", "\\u001B[31mok\\u0007"),
                argumentSet("terminal is cleared by one byte", "\u009B2J", "\\u009B2J"),
                argumentSet("line is overwritten", "wrong\rok   ", "wrong\\u000Dok   "),
                argumentSet("text is turned round", "a\u202Eb\u2066c", "a\\u202Eb\\u2066c"),
                argumentSet("text hides", "a\u200Bb\uFEFF", "a\\u200Bb\\uFEFF"),
                argumentSet("tag characters hide", "\uDB40\uDC41", "\\u{E0041}"),
                argumentSet("half a character breaks JSON", "a\uD800b", "a\\uD800b"),
                argumentSet("unassigned", "\u0378\uFFFF", "\\u0378\\uFFFF"),
                argumentSet("line separator", "a\u2028b", "a\\u2028b"),
                argumentSet("letters are spoilt", "ж é 漢 😀 №", "ж é 漢 😀 №"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("texts")
    void isShownInACase(String text, String shown) {
        assertEquals(shown, message(text));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("texts")
    void isShownInADiagnostic(String text, String shown) {
        assertEquals(shown, new Diagnostic(1, 1, Message.quoted(text)).message());
    }

    @Test
    void aDiagnosticKeepsItsLinesAndACaseIsOneLine() {
        assertEquals("a\n\tb\nc", new Diagnostic(1, 1, Message.quoted("a\n\tb\r\nc")).message());
        assertEquals("a\\n\\tb", message("a\n\tb"));
    }

    @Test
    void aTextWithoutEndIsCut() {
        String shown = message("x".repeat(1_000_000));
        assertEquals("x".repeat(VisibleText.MOST) + "…", shown);
    }

    private static String message(String text) {
        return new CaseReport(
                        "gap",
                        Disclosure.OPEN,
                        GradingVerdict.WRONG,
                        0,
                        3,
                        Message.quoted(text),
                        List.of(),
                        "")
                .message();
    }
}
