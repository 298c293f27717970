package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;
import rasterlab.tests.display.OwnDisplay;
import rasterlab.tests.process.JavaCommand;

/** Checks what is left of a window whose process is ended from outside. */
@Tag("slow")
@Timeout(300)
@ExtendWith(OwnDisplay.class)
class EndedWindowTest {
    @TempDir Path folder;
    private final List<String> problems = new ArrayList<>();

    @BeforeEach
    void needsDisplay() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
    }

    @Test
    void endedProgramOpensAsItWasLeft() throws Exception {
        Process window = changed();
        assumeTrue(window.supportsNormalTermination(), "this system only kills");
        window.destroy();
        window.waitFor();
        assertKept();
    }

    /** Nothing runs at its end, so what is there was written while it ran. */
    @Test
    void killedProgramHasWrittenWhatChanged() throws Exception {
        Process window = changed();
        WindowHarness.await("the labs are written", this::methodIsWritten);
        window.destroyForcibly();
        window.waitFor();
        assertKept();
    }

    private void assertKept() throws IOException {
        LabSettings kept =
                new SettingsFile(settings(), each -> problems.add(each.toString()))
                        .load(LabSettings.first(Language.ENGLISH));
        assertEquals(List.of(), problems);
        assertEquals(LabTheme.DARK, kept.look().theme());
        assertEquals(Language.RUSSIAN, kept.look().language());
        assertEquals("spline", kept.tab());
        assertTrue(methodIsWritten());
        try (var files = Files.list(folder)) {
            List<String> unfinished =
                    files.map(file -> file.getFileName().toString())
                            .filter(name -> name.endsWith(".part"))
                            .toList();
            assertEquals(List.of(), unfinished);
        }
    }

    private boolean methodIsWritten() {
        Path labs = folder.resolve("labs.json");
        return Files.exists(labs) && Repository.text(labs).contains("\"dda\"");
    }

    private Path settings() {
        return folder.resolve("window.properties");
    }

    /** The process as soon as it says that it changed what it shows. */
    private Process changed() throws IOException {
        Process process =
                new ProcessBuilder(
                                JavaCommand.of(
                                        ChildProcess.SHORT_LIVED,
                                        EndedWindow.class.getName(),
                                        List.of(settings().toString())))
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        String said = process.inputReader(StandardCharsets.UTF_8).readLine();
        assertEquals(EndedWindow.CHANGED, said);
        return process;
    }
}
