package rasterlab.app.shell.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.shell.WindowStart;

@Timeout(300)
class OneWindowTest {
    private static final String HELD = "held";

    @TempDir Path folder;

    /** Holds the settings, as a program of its own, until it is ended. */
    public static void main(String[] arguments) throws Exception {
        OneWindow.hold(Path.of(arguments[0]), problem -> System.out.println(problem));
        System.out.println(HELD);
        Thread.currentThread().join();
    }

    @Test
    void secondWindowIsTold() throws Exception {
        Path settings = folder.resolve("window.properties");
        Process other = other(settings);
        try {
            var problems = new ArrayList<Problem>();
            OneWindow.hold(settings, problems::add);
            assertEquals(1, problems.size());
            for (Language language : Language.values())
                assertTrue(problems.get(0).in(language).length() > 40);
        } finally {
            other.destroyForcibly();
            other.waitFor();
        }
        var problems = new ArrayList<Problem>();
        OneWindow.hold(settings, problems::add);
        assertEquals(List.of(), problems, "the other window is gone");
    }

    private static Process other(Path settings) throws IOException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classPath =
                System.getProperty(
                        "surefire.test.class.path", System.getProperty("java.class.path"));
        Process process =
                new ProcessBuilder(
                                java,
                                "-cp",
                                classPath,
                                OneWindowTest.class.getName(),
                                settings.toString())
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        assertEquals(HELD, process.inputReader().readLine());
        return process;
    }

    @Test
    void secondWindowLeavesWhatTheFirstKeeps() throws Exception {
        Path settings = folder.resolve("window.properties");
        var file = new SettingsFile(settings, problem -> {});
        LabSettings read = LabSettings.first(Language.ENGLISH);
        LabSettings changed = LabSettings.first(Language.RUSSIAN);
        Process other = other(settings);
        try {
            file.save(changed);
            WindowStart.keep(read, file, settings, problem -> {});
            assertEquals(changed, file.load(read));
        } finally {
            other.destroyForcibly();
            other.waitFor();
        }
        WindowStart.keep(read, file, settings, problem -> {});
        assertEquals(read, file.load(changed));
    }
}
