package rasterlab.tests.bench.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;
import rasterlab.tests.process.JavaCommand;

class SettingsFolderTest {
    /** Ends with its folder open, as Ctrl+C ends a benchmark. */
    static final class Stopped {
        private Stopped() {}

        public static void main(String[] none) throws IOException {
            var folder = new SettingsFolder();
            Files.writeString(folder.settings(), "theme=dark");
            System.out.println(folder.settings());
            System.exit(7);
        }
    }

    @Test
    void programThatEndsFirstLeavesNoSettings() {
        var run =
                ChildProcess.run(
                        Repository.root(),
                        Map.of(),
                        Duration.ofMinutes(1),
                        JavaCommand.of(List.of(), Stopped.class.getName(), List.of()));
        assertEquals(7, run.exit(), run.err());
        assertFalse(Files.exists(Path.of(run.out().strip()).getParent()), run::out);
    }

    @Test
    void closingLeavesNoSettings() throws IOException {
        Path settings;
        try (var folder = new SettingsFolder()) {
            settings = folder.settings();
            Files.writeString(settings, "theme=dark");
        }
        assertFalse(Files.exists(settings.getParent()));
    }
}
