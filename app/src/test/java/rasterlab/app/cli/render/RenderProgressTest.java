package rasterlab.app.cli.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.ReportLanguage;

class RenderProgressTest {
    @Test
    @DisplayName("a line comes every two seconds, which fills the screen")
    void saysItLessAndLessOften() {
        var err = new ByteArrayOutputStream();
        var progress =
                new RenderProgress(
                        Console.of(
                                InputStream.nullInputStream(),
                                new PrintStream(OutputStream.nullOutputStream()),
                                new PrintStream(err),
                                ReportLanguage.asked(new String[0])));
        for (long second = 0; second <= 40; second++) progress.tell(second);
        assertEquals(
                List.of(2, 4, 8, 16, 32).stream().map(s -> "rendering for " + s + " s").toList(),
                err.toString(StandardCharsets.UTF_8).lines().toList());
    }
}
