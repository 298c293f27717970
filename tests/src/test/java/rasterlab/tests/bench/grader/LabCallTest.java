package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class LabCallTest {
    private static final LabCall WORKER = LabCall.worker(Path.of("home"), Path.of("data"));

    @Test
    @DisplayName("a worker is called with other options than asked for")
    void callsTheScript() {
        String script = Path.of("home", "lab").toString();
        assertEquals(
                List.of(script, "grader", "worker", "--data", "data"),
                WORKER.process().command().subList(0, 5));
        List<String> named = WORKER.with("--name", "a").process().command();
        assertEquals(List.of("--name", "a"), named.subList(named.size() - 2, named.size()));
    }

    @Test
    @DisplayName("Java raises the limit of files that the shell has set")
    void limitsFilesInAShell() {
        ProcessBuilder process = WORKER.withFiles(99).process();
        assertEquals(
                List.of("sh", "-c", "ulimit -Sn \"$0\" && exec \"$@\"", "99"),
                process.command().subList(0, 4));
        assertEquals("grader", process.command().get(5));
        assertEquals("-XX:-MaxFDLimit", process.environment().get("JDK_JAVA_OPTIONS"));
    }

    @Test
    @DisplayName("a variable is lost where another one follows")
    void keepsVariables() {
        Map<String, String> environment =
                WORKER.withVariables(Map.of("A", "1"))
                        .withVariables(Map.of("B", "2"))
                        .process()
                        .environment();
        assertEquals("1", environment.get("A"));
        assertEquals("2", environment.get("B"));
    }
}
