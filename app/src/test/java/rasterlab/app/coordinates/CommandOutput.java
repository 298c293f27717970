package rasterlab.app.coordinates;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import rasterlab.app.cli.Lab;

/** Runs commands that the labs copy. */
public final class CommandOutput {
    private CommandOutput() {}

    /** The output of {@code echo 'JSON' | ./lab run TOPIC METHOD}. */
    public static JsonNode of(String command) throws IOException {
        assertTrue(command.startsWith("echo '"), command);
        int end = command.indexOf("' | ./lab ");
        String json = command.substring("echo '".length(), end);
        String[] words = command.substring(end + "' | ./lab ".length()).split(" ");
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int exitCode =
                Lab.run(
                        words,
                        new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)),
                        new PrintStream(out),
                        new PrintStream(err));
        assertEquals(0, exitCode, err.toString(StandardCharsets.UTF_8));
        return new ObjectMapper().readTree(out.toString(StandardCharsets.UTF_8));
    }
}
