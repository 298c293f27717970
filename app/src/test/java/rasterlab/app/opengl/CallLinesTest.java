package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CallLinesTest {
    private static final String LONG = "glLightfv(GL_LIGHT0, GL_AMBIENT, {0.15, 0.15, 0.15, 1});";

    @ParameterizedTest(name = "{0}")
    @CsvSource(
            delimiter = ';',
            value = {
                "short call is broken; 20; glEnable(GL_BLEND) ; glEnable(GL_BLEND)",
                "vector is broken though it has room; 40; glF(GL_LIGHT0, GL_AMBIENT, {0.1, 0.1, 1}) ;"
                        + " glF(GL_LIGHT0, GL_AMBIENT,|{0.1, 0.1, 1})",
                "long vector stays whole; 12; glF({0.1, 0.1, 0.1}) ; glF({0.1,|0.1,|0.1})",
                "line with no argument is cut in a word; 14; glEnable(GL_BLEND) ;"
                        + " glEnable(|GL_BLEND)",
                "line of one name is too long; 12; GL_FRONT_AND_BACK ; GL_FRONT_|AND_BACK"
            })
    void breaksWhereItIsRead(String mistake, int columns, String call, String lines) {
        assertEquals(lines, String.join("|", CallLines.of(call, columns)), mistake);
    }

    @ParameterizedTest(name = "a line of {0} columns is too long, or a letter is lost")
    @ValueSource(ints = {8, 13, 21, 34, 55, 56, 89})
    void nothingIsLostOrCut(int columns) {
        List<String> lines = CallLines.of(LONG, columns);
        assertEquals(LONG.replace(" ", ""), String.join("", lines).replace(" ", ""));
        IntStream.range(0, lines.size())
                .forEach(
                        i ->
                                assertTrue(
                                        lines.get(i).length() + (i > 0 ? CallLines.INDENT : 0)
                                                <= columns,
                                        lines.toString()));
    }
}
