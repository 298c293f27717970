package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.Main;

/** Types of the product that a short command loads, which is most of the time it takes. */
class LoadedTypesTest {
    private static final int MOST = 100;

    @TempDir Path folder;

    /** Topics and commands are made when they are asked for. */
    @Test
    void aRunOfOneMethodLoadsNoOtherTopicsAndCommands() throws Exception {
        List<String> types = loadedBy("{\"from\":[0,0],\"to\":[2,1]}", "run", "line", "bresenham");
        assertTrue(
                types.size() <= MOST,
                () -> types.size() + " types are loaded:\n" + String.join("\n", types));
    }

    private List<String> loadedBy(String input, String... arguments)
            throws IOException, InterruptedException {
        Path log = folder.resolve("types.log");
        Path answer = folder.resolve("answer");
        var command =
                new ArrayList<>(
                        List.of(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "-Xlog:class+load:file=" + log,
                                "-cp",
                                System.getProperty("java.class.path"),
                                Main.class.getName()));
        command.addAll(List.of(arguments));
        Process process =
                new ProcessBuilder(command)
                        .redirectErrorStream(true)
                        .redirectOutput(answer.toFile())
                        .start();
        try (var to = process.getOutputStream()) {
            to.write(input.getBytes(StandardCharsets.UTF_8));
        }
        assertEquals(0, process.waitFor(), () -> answer(answer));
        return Files.readAllLines(log).stream()
                .filter(line -> line.contains(" rasterlab."))
                .toList();
    }

    private static String answer(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }
}
