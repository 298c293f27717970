package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.Main;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.process.JavaCommand;

/** Checks what is left of a study whose process is asked to end while it measures. */
@Tag("slow")
@Timeout(300)
class StoppedStudyTest {
    @TempDir Path folder;

    private record Stopped(JsonNode json, String out) {
        /** How many rounds each measurement has. */
        List<Integer> rounds() {
            return StreamSupport.stream(json.path("measurements").spliterator(), false)
                    .map(one -> one.path("rounds").size())
                    .toList();
        }
    }

    /** Ends the study as soon as it tells that it came to a tenth of its work. */
    private Stopped stopped(String... settings) throws Exception {
        Path file = folder.resolve("shade.json");
        var call = new ArrayList<>(List.of("study", "shade", "--out", file.toString()));
        call.addAll(List.of(settings));
        Process study =
                new ProcessBuilder(
                                JavaCommand.of(
                                        ChildProcess.SHORT_LIVED, Main.class.getName(), call))
                        .start();
        assumeTrue(study.supportsNormalTermination(), "this system only kills");
        BufferedReader told = study.errorReader(StandardCharsets.UTF_8);
        assertTrue(told.readLine().startsWith("10 % measured"));
        // Process.destroy would close what the study still writes to
        study.toHandle().destroy();
        String out = new String(study.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        study.waitFor();
        return new Stopped(new ObjectMapper().readTree(file.toFile()), out);
    }

    @Test
    @DisplayName("the rounds that were measured are lost, or look like a whole study")
    void roundsMeasuredSoFarAreKept() throws Exception {
        Stopped study = stopped("--quick", "--rounds", "100");
        assertFalse(study.json.path("whole").asBoolean(true));
        assertEquals("between rounds", study.json.path("stopped").asText());
        assertTrue(
                study.rounds().stream().allMatch(rounds -> rounds > 0), study.rounds()::toString);
        assertTrue(study.rounds().stream().anyMatch(rounds -> rounds < 100), "it was whole");
        assertTrue(study.out.contains("Stopped before its end"), study.out);
    }

    @Test
    @DisplayName("nobody learns why nothing was timed, or 0 ns stand where nothing was timed")
    void studyThatWasWarmingUpSaysSo() throws Exception {
        Stopped study = stopped("--rounds", "1", "--seconds", "0");
        assertFalse(study.json.path("whole").asBoolean(true));
        assertEquals("before the first round", study.json.path("stopped").asText());
        assertTrue(study.rounds().stream().allMatch(rounds -> rounds == 0));
        assertTrue(study.json.path("measurements").path(0).path("nanosPerItem").isNull());
        assertTrue(study.out.contains("Stopped before the first round"), study.out);
    }
}
