package rasterlab.tests.bench.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;
import rasterlab.tests.display.OwnDisplay;
import rasterlab.tests.process.JavaCommand;

@Tag("slow")
@ExtendWith(OwnDisplay.class)
class WindowBenchTest {
    @Test
    void everyDragChangesThePicture() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        var bench =
                ChildProcess.run(
                        Repository.root(),
                        Map.of(),
                        Duration.ofMinutes(3),
                        JavaCommand.of(List.of("-Xmx600m"), ShortBench.class.getName(), List.of()));
        assertEquals(0, bench.exit(), bench::toString);
        List<String> frames =
                bench.out().lines().filter(line -> line.contains("frames a second")).toList();
        boolean openGl = !bench.out().contains("not measured");
        assertEquals(openGl ? 5 : 4, frames.size(), bench::toString);
        for (String line : frames) assertFalse(line.contains(" 0 frames"), line);
    }
}
