package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

/** The README's calls with curl, on a server of the test's own. */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the README's commands are for a POSIX shell")
class ReadmeCallsTest {
    private static final Pattern BLOCK =
            Pattern.compile("(?m)^```\\R(curl .*?)^```", Pattern.DOTALL);

    @TempDir private Path folder;

    @Test
    void makeACourseJoinItAndSubmit() throws Exception {
        try (var server = ServerProcess.start(folder.resolve("course"))) {
            var calls = calls(server.address().toString());
            assertEquals(3, calls.size(), calls.toString());
            var code = call(calls.get(0), Map.of("TOKEN", server.token())).path("code").asText();
            var joined = call(calls.get(1).replace("CODE", code), Map.of());
            var token = joined.path("token").asText();
            Files.writeString(folder.resolve("Bresenham.java"), Solutions.source(Solutions.RIGHT));
            var accepted = call(calls.get(2), Map.of("STUDENT", token));
            assertTrue(accepted.path("id").isTextual(), accepted.toString());
        }
    }

    private static List<String> calls(String address) {
        var block = BLOCK.matcher(Repository.text(Repository.root().resolve("README.md")));
        assertTrue(block.find(), "README has no block of curl commands");
        var lines = block.group(1).replace("http://127.0.0.1:8080", address);
        return lines.replaceAll("\\\\\\R\\s*", "").lines().toList();
    }

    private JsonNode call(String command, Map<String, String> environment) throws Exception {
        var run =
                ChildProcess.run(
                        folder, environment, Duration.ofMinutes(5), List.of("sh", "-c", command));
        Assumptions.assumeTrue(run.exit() != 127, "there is no curl");
        assertEquals(0, run.exit(), command + "\n" + run.out() + run.err());
        return new ObjectMapper().readTree(run.out());
    }
}
