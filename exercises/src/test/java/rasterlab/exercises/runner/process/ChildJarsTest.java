package rasterlab.exercises.runner.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The temporary folder outlives neither its judge nor its own loss. */
@Tag("slow")
class ChildJarsTest {
    @TempDir Path temporary;

    @ParameterizedTest(name = "a cleaner of temporary files takes {0}")
    @ValueSource(strings = {"contract.jar", "harness.jar", "system-calls.bpf", "lock", "."})
    void areMadeAnewWhenTheyAreTakenAway(String taken) throws IOException {
        try (ChildJars jars = ChildJars.assemble(temporary)) {
            Path before = jars.folder();
            removeAll(taken.equals(".") ? before : before.resolve(taken));
            assertTrue(Files.exists(jars.contract()), "contract.jar");
            assertTrue(Files.exists(jars.harness()), "harness.jar");
            assertEquals(List.of(jars.folder()), folders(), "the old folder stays");
        }
        assertEquals(List.of(), folders());
    }

    /** No method and no reference: a student's code finds nothing there to copy an answer from. */
    @Test
    void holdContractsAndTheHarnessAlone() throws IOException {
        try (ChildJars jars = ChildJars.assemble(temporary)) {
            assertEquals(Set.of("rasterlab/contract"), packages(jars.contract()));
            assertEquals(Set.of("rasterlab/exercises/child"), packages(jars.harness()));
        }
    }

    private static Set<String> packages(Path jar) throws IOException {
        try (JarFile file = new JarFile(jar.toFile())) {
            return file.stream()
                    .map(entry -> entry.getName().replaceAll("/[^/]*$", ""))
                    .collect(Collectors.toSet());
        }
    }

    @Test
    void leftoversOfAKilledJudgeAreRemovedAndThoseOfALivingOneStay() throws Exception {
        Process other = judge();
        try {
            assertTrue(other.inputReader().readLine().startsWith("ready"), "no other judge");
            List<Path> its = folders();
            ChildJars.assemble(temporary).close();
            assertEquals(its, folders(), "a living judge lost its folder");
            other.destroyForcibly();
            assertTrue(other.waitFor(2, TimeUnit.MINUTES), "not killed");
            assertEquals(its, folders());
            ChildJars.assemble(temporary).close();
            assertEquals(List.of(), folders());
        } finally {
            other.destroyForcibly();
        }
    }

    @Test
    void twoJudgesOfOneProcessLeaveEachOtherAlone() {
        try (ChildJars first = ChildJars.assemble(temporary);
                ChildJars second = ChildJars.assemble(temporary)) {
            Path folder = first.folder();
            assertTrue(Files.exists(second.harness()));
            assertEquals(folder, first.folder());
        }
    }

    @Test
    void aFolderThatIsJustBeingMadeStays() throws IOException {
        Path young = Files.createDirectory(temporary.resolve("rasterlab-children-1-new"));
        ChildJars.assemble(temporary).close();
        assertTrue(Files.exists(young));
    }

    @Test
    void aFolderWithSomethingElseInItKeepsThat() throws IOException {
        Path old = Files.createDirectory(temporary.resolve("rasterlab-children-1-old"));
        Files.createFile(old.resolve("lock"));
        Path strange = Files.createFile(old.resolve("thesis.tex"));
        ChildJars.assemble(temporary).close();
        assertTrue(Files.exists(strange));
        assertFalse(Files.exists(old.resolve("contract.jar")));
    }

    private Process judge() throws IOException {
        return new ProcessBuilder(
                        Programs.java(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        LivingJars.class.getName(),
                        temporary.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private List<Path> folders() throws IOException {
        try (Stream<Path> all = Files.list(temporary)) {
            return all.toList();
        }
    }

    private static void removeAll(Path top) throws IOException {
        try (Stream<Path> all = Files.walk(top)) {
            for (Path one : all.sorted(java.util.Comparator.reverseOrder()).toList())
                Files.delete(one);
        }
    }
}
