package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The server's heap is limited before Java starts, so {@code ./lab} reads that option itself. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell runs the script under test")
class HeapCallTest {
    @TempDir private Path folder;

    @ParameterizedTest(name = "./lab {0} starts Java with a heap other than {1}")
    @CsvSource({
        "grader serve,-Xmx256m",
        "grader serve --data course --heap 512,-Xmx512m",
        "grader serve --heap=100 --port 0,-Xmx100m",
        "--lang ru grader serve --heap 80,-Xmx80m",
        "grader serve --heap 63,-Xmx256m",
        "grader serve --heap 9999999,-Xmx256m",
        "grader serve --heap 65536,-Xmx65536m",
        "grader serve --heap 65537,-Xmx256m",
        "grader serve --heap 1g,-Xmx256m",
        "grader serve --heap,-Xmx256m",
        "grader serve --data=--heap=512x,-Xmx256m",
        "methods,",
    })
    void startsJavaWithThatHeap(String call, String heap) throws IOException {
        var lab = BuiltLab.in(folder, "for word in \"$@\"; do echo \"$word\"; done");
        var run = lab.call(List.of(call.split(" ")));
        assertEquals(0, run.exit(), run.err());
        var found = run.out().lines().filter(word -> word.startsWith("-Xmx")).toList();
        assertEquals(heap == null ? List.of() : List.of(heap), found, run.out());
    }
}
