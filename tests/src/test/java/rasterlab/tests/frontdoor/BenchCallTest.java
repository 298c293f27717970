package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.bench.Bench;

/** Java warns of the Vector API on the error stream, so only what measures may ask for it. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell runs the script under test")
class BenchCallTest {
    private static final String REFUSED = "no-such-work";

    /** Says what it is called with, and refuses one work when only asked about it. */
    private static final String SAYING =
            "echo \"$*\" | grep -q -e '--arguments-only .*%s' && exit 2; echo \"$@\""
                    .formatted(REFUSED);

    @TempDir Path folder;

    @ParameterizedTest(name = "{0} is measured without the Vector API")
    @MethodSource("groups")
    void everyGroupIsMeasuredWithTheVectorApi(String group) throws IOException {
        assertTrue(asksForVectors("--quick", group), group);
    }

    static Stream<String> groups() {
        return Bench.groups().stream();
    }

    @ParameterizedTest(name = "{0} has Java warn of the Vector API")
    @ValueSource(strings = {"--help", "-h pipeline", "pipeline --help", "--version", "nosuch", ""})
    void whatMeasuresNothingDoesWithout(String arguments) throws IOException {
        assertEquals(false, asksForVectors(arguments.split(" ")), arguments);
    }

    @Test
    @DisplayName("Java warns before what is wrong with the arguments is told")
    void wrongArgumentsAreToldWithoutTheVectorApi() throws IOException {
        var run = called("raster", "--only", REFUSED);
        assertEquals(2, run.exit(), run.err());
        assertFalse(run.out().contains("/engine/vector-options"), run.out());
    }

    @ParameterizedTest(name = "./lab {0} is not: {1}")
    @CsvSource({
        "--lang ru bench raster, rasterlab.tests.bench.Bench --lang ru raster",
        "--lang=ru bench raster, rasterlab.tests.bench.Bench --lang=ru raster",
        "--lang ru grader serve, rasterlab.grader.MainKt --lang ru serve",
        "--lang ru methods line, rasterlab.app.Main --lang ru methods line",
        "--lang ru, rasterlab.app.Main --lang ru"
    })
    void languageMayStandInFrontOfEachProgram(String words, String started) throws IOException {
        var run = calledWith(List.of(words.split(" ")));
        assertEquals(0, run.exit(), run.err());
        assertTrue(run.out().strip().endsWith(started), run.out());
    }

    private boolean asksForVectors(String... arguments) throws IOException {
        var run = called(arguments);
        assertEquals(0, run.exit(), run.err());
        assertTrue(run.out().contains(Bench.class.getName()), run.out());
        return run.out().contains("/engine/vector-options");
    }

    private ChildProcess called(String... arguments) throws IOException {
        return calledWith(Stream.concat(Stream.of("bench"), Stream.of(arguments)).toList());
    }

    private ChildProcess calledWith(List<String> words) throws IOException {
        return BuiltLab.in(folder, SAYING).call(words);
    }
}
