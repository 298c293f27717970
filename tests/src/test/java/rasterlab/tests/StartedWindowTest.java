package rasterlab.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabLook;
import rasterlab.app.shell.LabSettings;
import rasterlab.app.shell.SettingsFile;

/** The window of a program that was left at a tab. */
@Timeout(120)
@ExtendWith(OwnDisplay.class)
class StartedWindowTest {
    @TempDir Path folder;

    @ParameterizedTest(name = "{0} does not open first")
    @ValueSource(strings = {"coordinates", "study", "exercises"})
    void opensAtTheTabWhereItWasLeft(String tab) throws IOException, InterruptedException {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        Path settings = folder.resolve("window.properties");
        new SettingsFile(
                        settings,
                        problem -> {
                            throw new AssertionError(problem);
                        })
                .save(
                        new LabSettings(
                                LabLook.first(Language.ENGLISH),
                                tab,
                                Optional.empty(),
                                false,
                                true));
        Process process =
                new ProcessBuilder(
                                JavaCommand.of(
                                        List.of("-Xmx400m", "-Drasterlab.settings=" + settings),
                                        StartedWindow.class.getName(),
                                        List.of()))
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        try {
            assertEquals(tab, process.inputReader(StandardCharsets.UTF_8).readLine());
        } finally {
            process.destroyForcibly();
            process.waitFor();
        }
    }
}
