package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Checks what the script starts, and with which words. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell runs the script under test")
class ProgramCallTest {
    /** Says what it is called with. */
    private static final String SAYING = "echo \"$@\"";

    @TempDir Path folder;

    @ParameterizedTest(name = "./lab {0} is not: {1}")
    @CsvSource({
        "--lang ru bench raster, rasterlab.tests.bench.Bench --lang ru raster",
        "--lang=ru bench raster, rasterlab.tests.bench.Bench --lang=ru raster",
        "--lang ru grader serve, rasterlab.grader.MainKt --lang ru serve",
        "--lang ru methods line, rasterlab.app.Main --lang ru methods line",
        "--lang ru, rasterlab.app.Main --lang ru",
        "help grader course list, rasterlab.grader.MainKt help course list",
        "help grader, rasterlab.grader.MainKt help",
        "help exercises new, rasterlab.app.Main help exercises new"
    })
    void eachProgramIsStartedWithItsOwnWords(String words, String started) throws IOException {
        var run = BuiltLab.in(folder, SAYING).call(List.of(words.split(" ")));
        assertEquals(0, run.exit(), run.err());
        assertTrue(run.out().strip().endsWith(started), run.out());
    }
}
