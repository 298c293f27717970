package rasterlab.tests.window;

import static java.util.concurrent.TimeUnit.MINUTES;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.GraphicsEnvironment;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.file.LastChosen;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.display.OwnDisplay;
import rasterlab.tests.process.JavaCommand;

/** The window of a program that was left at a tab. */
@Tag("slow")
@Timeout(300)
@ExtendWith(OwnDisplay.class)
class StartedWindowTest {
    @TempDir Path folder;

    @BeforeEach
    void needsDisplay() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
    }

    @ParameterizedTest(name = "{0} does not open first")
    @ValueSource(strings = {"coordinates", "study", "exercises"})
    void opensAtTheTabWhereItWasLeft(String tab) throws Exception {
        leaveAt(tab);
        assertEquals(List.of(tab + " ENGLISH"), opened(1));
    }

    @Test
    void tellsWhatCannotBeBroughtBack() throws Exception {
        leaveAt("coordinates");
        Files.writeString(folder.resolve("labs.json"), "{");
        String title = Texts.of("shell", Language.ENGLISH).text("problem.title");
        assertEquals(title, opened(2).get(1));
    }

    @ParameterizedTest(name = "the window opens in English after {0}, or always in Russian")
    @ValueSource(strings = {"--lang ru", "--lang=RU"})
    void opensInTheLanguageAskedForThisOnce(String asked) throws Exception {
        leaveAt("line");
        assertEquals(List.of("line RUSSIAN"), opened(1, asked.split(" ")));
        assertEquals(List.of("line ENGLISH"), opened(1));
    }

    @Test
    @DisplayName("what fails before there is a window is told in English")
    void earlyFailureIsToldInTheLanguageAskedFor() throws Exception {
        leaveAt("line");
        String title = Texts.of("shell", Language.RUSSIAN).text("error.title");
        assertEquals(List.of(title), opened(FailedStart.class, 1, "--lang", "ru"));
    }

    private void leaveAt(String tab) {
        new SettingsFile(
                        settings(),
                        problem -> {
                            throw new AssertionError(problem);
                        })
                .save(
                        new LabSettings(
                                LabLook.first(Language.ENGLISH),
                                tab,
                                Optional.empty(),
                                false,
                                true,
                                LastChosen.NONE));
    }

    private Path settings() {
        return folder.resolve("window.properties");
    }

    private List<String> opened(int windows, String... arguments) throws Exception {
        return opened(StartedWindow.class, windows, arguments);
    }

    /** The first windows of a new process. */
    private List<String> opened(Class<?> program, int windows, String... arguments)
            throws Exception {
        var options = new ArrayList<>(ChildProcess.SHORT_LIVED);
        options.add("-Drasterlab.settings=" + settings());
        Process process =
                new ProcessBuilder(JavaCommand.of(options, program.getName(), List.of(arguments)))
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        try {
            BufferedReader output = process.inputReader(StandardCharsets.UTF_8);
            var said = new ArrayList<String>();
            while (said.size() < windows) {
                // Nothing interrupts reading from a pipe.
                String line = CompletableFuture.supplyAsync(() -> next(output)).get(2, MINUTES);
                if (line == null)
                    fail("ended with " + process.onExit().get(2, MINUTES).exitValue());
                said.add(line);
            }
            return said;
        } finally {
            process.destroyForcibly();
            process.waitFor();
        }
    }

    private static String next(BufferedReader output) {
        try {
            return output.readLine();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
