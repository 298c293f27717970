package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class BenchTest {
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    @Test
    void anUnknownGroupIsAnsweredWithThoseThereAre() {
        assertEquals(2, run("nosuch"));
        assertEquals(
                "./lab bench: unknown group 'nosuch'; allowed are pipeline, raster, window"
                        + " (see `./lab bench --help`)",
                said());
    }

    @Test
    void anUnknownWorkIsAnsweredWithThoseThereAre() {
        assertEquals(2, run("raster", "--only", "nosuch"));
        assertTrue(said().startsWith("./lab bench: no goal has 'nosuch' in its work; "), said());
        for (Goal goal : RasterGoals.all()) assertTrue(said().contains(goal.work()), said());
        assertTrue(said().matches("[^\\[\\]]*"), said());
    }

    @Test
    void anUnknownWorkOfThePipelineIsAnsweredToo() {
        assertEquals(2, run("pipeline", "--only", "nosuch"));
        assertTrue(said().startsWith("./lab bench: no goal has 'nosuch' in its work; "), said());
        assertTrue(said().contains("; threads; clear; "), said());
    }

    @Test
    void whatDoesNotGoTogetherIsTold() {
        assertEquals(2, run("window", "--only", "line"));
        assertEquals(2, run("raster", "--minutes", "3"));
        assertEquals(2, run("window", "--minutes", "-1"));
        assertEquals(
                List.of(
                        "--only goes with the groups raster and pipeline, not with window",
                        "--minutes goes with the group window, not with raster",
                        "--minutes must be at least 0, got -1"),
                said().lines()
                        .map(line -> line.replaceAll("^./lab bench: | \\(see.*", ""))
                        .toList());
    }

    @Test
    void argumentsAloneAreCheckedAndNothingIsMeasured() {
        assertEquals(0, run("--arguments-only", "raster", "--quick"));
        assertEquals(2, run("--arguments-only", "raster", "--only", "nosuch"));
    }

    private int run(String... arguments) {
        return Bench.commandLine(new PrintStream(err, true, StandardCharsets.UTF_8))
                .execute(arguments);
    }

    private String said() {
        return err.toString(StandardCharsets.UTF_8).strip();
    }
}
