package rasterlab.tests.bench.window;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import rasterlab.app.Main;
import rasterlab.tests.process.JavaCommand;

/** Starts the lab in a process of its own and tells how long it took to show its first tab. */
final class StartUp {
    private static final int LIMIT_SECONDS = 60;

    private StartUp() {}

    /** Opens the window, prints the milliseconds since the process began, and ends. */
    public static void main(String[] none) {
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(
                        event -> {
                            if (event.getID() == WindowEvent.WINDOW_OPENED) tell();
                        },
                        AWTEvent.WINDOW_EVENT_MASK);
        Main.main(new String[0]);
    }

    /** Tells when what is waiting to be painted has been painted and has reached the display. */
    private static void tell() {
        EventQueue.invokeLater(
                () -> {
                    Toolkit.getDefaultToolkit().sync();
                    long began = ManagementFactory.getRuntimeMXBean().getStartTime();
                    System.out.println(System.currentTimeMillis() - began);
                    Runtime.getRuntime().halt(0);
                });
    }

    /**
     * Milliseconds from the start of a process, with settings of a first run, to its painted
     * window.
     *
     * @throws IOException if the process cannot be started or ends without a window
     */
    static long milliseconds() throws IOException, InterruptedException {
        try (var folder = new SettingsFolder()) {
            return milliseconds(folder.settings());
        }
    }

    private static long milliseconds(Path settings) throws IOException, InterruptedException {
        Process process =
                new ProcessBuilder(
                                JavaCommand.of(
                                        List.of(
                                                "@" + options(),
                                                "-Drasterlab.settings=" + settings),
                                        StartUp.class.getName(),
                                        List.of()))
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        try {
            if (!process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS))
                throw new IOException("no window after " + LIMIT_SECONDS + " s");
            String said = new String(process.getInputStream().readAllBytes()).strip();
            if (process.exitValue() != 0 || said.isEmpty())
                throw new IOException("the lab ended with " + process.exitValue());
            return Long.parseLong(said.lines().reduce((one, other) -> other).orElseThrow());
        } finally {
            process.destroyForcibly().waitFor();
        }
    }

    /** The options that {@code ./lab} starts the window with. */
    private static Path options() {
        return Path.of(System.getProperty("rasterlab.home", ""), "app", "java-options");
    }
}
