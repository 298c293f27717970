package rasterlab.exercises.runner.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

class ProcessorTimeTest {
    @Test
    @DisplayName("a program's name, or another field, is taken for its time")
    void addsTheTwoTimes() {
        String line =
                "71 (a (b) 9 c) S 1 71 71 0 -1 4194560 2 3 4 5 123 45 67 89 20 0 30 0 9 10 11\n";
        assertEquals(Duration.ofMillis(1680), ProcessorTime.ofLine(line));
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    @DisplayName("a hundredth of a second is another time on this system")
    void agreesWithJavaOnItsOwnProcess() throws IOException {
        ProcessHandle own = ProcessHandle.current();
        Duration before = own.info().totalCpuDuration().orElseThrow();
        Path stat = Path.of("/proc", String.valueOf(own.pid()), "stat");
        Duration read = ProcessorTime.ofLine(Files.readString(stat));
        Duration after = own.info().totalCpuDuration().orElseThrow();
        assertTrue(
                before.compareTo(read) <= 0 && read.compareTo(after) <= 0,
                () -> before + " ≤ " + read + " ≤ " + after);
    }
}
