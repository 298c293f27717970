package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

/** The server's heap is limited before Java starts, so {@code ./lab} reads that option itself. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell runs the script under test")
class HeapCallTest {
    @TempDir private Path folder;

    /** As if it were built, with a Java that prints how it is called. */
    @BeforeEach
    void prepare() throws IOException {
        for (var file : List.of("lab", "app/java-options", "engine/vector-options")) {
            Files.createDirectories(folder.resolve(file).getParent());
            Files.copy(Repository.root().resolve(file), folder.resolve(file));
        }
        var built = folder.resolve("target/lab/built");
        Files.createDirectories(built.getParent());
        Files.createFile(built);
        program("bin/javac", "#!/bin/sh\n");
        program(
                "bin/java",
                """
                #!/bin/sh
                if [ "$1" = -XshowSettings:properties ]; then
                    echo '    java.specification.version = 17'
                    echo '    java.home = %s'
                else
                    for word in "$@"; do echo "$word"; done
                fi
                """
                        .formatted(folder));
    }

    private void program(String name, String text) throws IOException {
        var file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

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
    void startsJavaWithThatHeap(String call, String heap) {
        var command = new ArrayList<>(List.of(folder.resolve("lab").toString()));
        command.addAll(List.of(call.split(" ")));
        var environment = Map.of("JAVA_HOME", folder.toString());
        var run = ChildProcess.run(folder, environment, Duration.ofMinutes(1), command);
        assertEquals(0, run.exit(), run.err());
        var found = run.out().lines().filter(word -> word.startsWith("-Xmx")).toList();
        assertEquals(heap == null ? List.of() : List.of(heap), found, run.out());
    }
}
