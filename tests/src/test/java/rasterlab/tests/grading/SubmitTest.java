package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.process.JavaCommand;

/** {@code ./lab submit} at a real server, with the token in the environment. */
@Tag("slow")
class SubmitTest {
    private static final Duration PATIENCE = Duration.ofMinutes(5);

    @TempDir private Path folder;

    @Test
    void aSolutionIsHandedInAndItsDocumentIsTheServersOwn() throws Exception {
        try (var server = ServerProcess.start(folder.resolve("course"))) {
            var student = GraderClient.of(server.address(), server.token()).joinNewCourse();
            var token = Map.of("RASTERLAB_TOKEN", student.token());
            var right = submitted(server.address(), Solutions.RIGHT, token, "--json");
            assertEquals(0, right.exit(), right.err());
            JsonNode document = new ObjectMapper().readTree(right.out());
            assertEquals(student.get("/submissions/" + document.get("id").asText()), document);
            var wrong = submitted(server.address(), Solutions.WRONG, token);
            assertEquals(1, wrong.exit(), wrong.err());
            assertTrue(wrong.out().contains("Verdict: wrong"), wrong.out());
            var unknown =
                    submitted(server.address(), Solutions.RIGHT, Map.of("RASTERLAB_TOKEN", "no"));
            assertEquals(2, unknown.exit(), unknown.err());
            assertTrue(unknown.err().contains("does not know the token"), unknown.err());
        }
    }

    private ChildProcess submitted(
            URI server, String solution, Map<String, String> environment, String... more)
            throws Exception {
        var file = Files.writeString(folder.resolve("Line.java"), Solutions.source(solution));
        var arguments = new ArrayList<>(List.of("submit", "line-bresenham", file.toString()));
        arguments.addAll(List.of("--server", server.toString()));
        arguments.addAll(List.of(more));
        return ChildProcess.run(
                folder,
                environment,
                PATIENCE,
                JavaCommand.of(ChildProcess.SHORT_LIVED, "rasterlab.app.Main", arguments));
    }
}
