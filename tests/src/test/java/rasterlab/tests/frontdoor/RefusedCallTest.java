package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

/** A call of {@code ./lab} that cannot be answered says why and what to do. */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell runs the script under test")
class RefusedCallTest {
    @Test
    void aFailedBuildShowsItsErrorsAndItsLog(@TempDir Path folder) throws IOException {
        FreshCopy.copySources(folder);
        var broken = folder.resolve("engine/src/main/java/rasterlab/contract/Pixels.java");
        Files.writeString(broken, Files.readString(broken) + "}");
        var run = run(folder, FreshCopy.withJava());
        assertEquals(1, run.exit());
        assertTrue(run.err().contains("Pixels.java"), run.err());
        assertTrue(
                run.err().contains(folder.toRealPath().resolve("target/lab/build.log").toString()),
                run.err());
    }

    @Test
    void withoutJavaOneLineTellsWhatToInstall(@TempDir Path folder) throws IOException {
        var environment = new HashMap<String, String>();
        environment.put("JAVA_HOME", null);
        environment.put("PATH", toolsWithoutJava(folder).toString());
        assertRefused(run(Repository.root(), environment), "no Java found");
    }

    @Test
    void aJavaTooOldIsNamed(@TempDir Path folder) throws IOException {
        var home = fakeJava(folder, "11");
        assertRefused(run(Repository.root(), Map.of("JAVA_HOME", home.toString())), "is Java 11; ");
    }

    @Test
    void aJavaOfTheOldNumberingIsNamed(@TempDir Path folder) throws IOException {
        var home = fakeJava(folder, "1.8");
        assertRefused(
                run(Repository.root(), Map.of("JAVA_HOME", home.toString())), "is Java 1.8; ");
    }

    @Test
    void aJavaWithoutCompilerIsRefused(@TempDir Path folder) throws IOException {
        var home = fakeJava(folder, "17");
        assertRefused(
                run(Repository.root(), Map.of("JAVA_HOME", home.toString())), "without a compiler");
    }

    @Test
    void aMissingFileOfOptionsIsNamed(@TempDir Path folder) throws IOException {
        String name = "app/java-options";
        var lab = BuiltLab.in(folder, "echo started");
        Files.delete(folder.resolve(name));
        var run = lab.call(List.of("methods"));
        assertEquals(1, run.exit(), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(run.err().contains("/" + name + " is missing"), run.err());
    }

    private static ChildProcess run(Path folder, Map<String, String> environment) {
        return ChildProcess.run(
                folder,
                environment,
                Duration.ofMinutes(5),
                List.of(folder.resolve("lab").toString(), "methods"));
    }

    private static void assertRefused(ChildProcess run, String words) {
        assertEquals(2, run.exit(), run.err());
        assertEquals("", run.out());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(run.err().contains(words) && run.err().contains("JDK 17 or later"), run.err());
    }

    private static Path toolsWithoutJava(Path folder) throws IOException {
        for (var tool : List.of("sh", "dirname", "readlink", "sed", "find", "head", "mkdir")) {
            for (var place : List.of("/usr/bin", "/bin")) {
                var real = Path.of(place, tool);
                var link = folder.resolve(tool);
                if (Files.exists(real) && !Files.exists(link)) Files.createSymbolicLink(link, real);
            }
        }
        return folder;
    }

    private static Path fakeJava(Path folder, String version) throws IOException {
        var java = folder.resolve("bin/java");
        Files.createDirectories(java.getParent());
        Files.writeString(
                java,
                "#!/bin/sh\necho '    java.specification.version = %s'\necho '    java.home = %s'\n"
                        .formatted(version, folder));
        Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwxr-xr-x"));
        return folder;
    }
}
