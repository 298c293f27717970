package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
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

    private int run(String... arguments) {
        return Bench.commandLine(new PrintStream(err, true, StandardCharsets.UTF_8))
                .execute(arguments);
    }

    private String said() {
        return err.toString(StandardCharsets.UTF_8).strip();
    }
}
