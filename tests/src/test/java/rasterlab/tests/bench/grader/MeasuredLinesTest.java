package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class MeasuredLinesTest {
    @Test
    @DisplayName("what is counted after an interrupt is printed")
    void printsNothingMoreOnceThisProcessIsToldToEnd() {
        var printed = new ByteArrayOutputStream();
        var over = new AtomicBoolean();
        var out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        var lines = new MeasuredLines(out, over::get);
        lines.println("before");
        over.set(true);
        lines.println("after");
        assertEquals("before", printed.toString(StandardCharsets.UTF_8).strip());
    }

    @Test
    @DisplayName("a process that goes on is taken for one that ends")
    void thisProcessIsNotEnding() {
        assertFalse(MeasuredLines.isProcessEnding());
    }
}
