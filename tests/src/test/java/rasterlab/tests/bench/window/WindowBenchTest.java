package rasterlab.tests.bench.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.swing.RepaintManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import rasterlab.tests.OwnDisplay;

@ExtendWith(OwnDisplay.class)
class WindowBenchTest {
    @AfterEach
    void paintAsUsual() {
        RepaintManager.setCurrentManager(null);
    }

    @Test
    void everyDragChangesThePicture() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        var text = new ByteArrayOutputStream();
        new WindowBench(1, 0.5, 0, new PrintStream(text, true, StandardCharsets.UTF_8)).run();
        List<String> frames =
                text.toString(StandardCharsets.UTF_8)
                        .lines()
                        .filter(line -> line.contains("frames a second"))
                        .toList();
        boolean openGl = !text.toString(StandardCharsets.UTF_8).contains("not measured");
        assertEquals(openGl ? 5 : 4, frames.size(), text::toString);
        for (String line : frames) assertFalse(line.contains(" 0 frames"), line);
    }
}
