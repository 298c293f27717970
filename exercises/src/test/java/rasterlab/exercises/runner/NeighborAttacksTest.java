package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Programs;

/** A method in its box sees, stops and tells no other one, past the byte-code check too. */
@Tag("slow")
class NeighborAttacksTest {
    private static Unscanned unscanned;

    @BeforeAll
    static void start() {
        assumeTrue(Programs.onPath("bwrap").isPresent(), "bubblewrap is missing");
        unscanned = new Unscanned(JudgeSettings.Protection.STRONGEST);
        assertEquals("bubblewrap", unscanned.box.isolation().name());
    }

    @AfterAll
    static void end() {
        if (unscanned != null) unscanned.close();
    }

    private static String telling(String body) {
        return method(
                "String found = \"\"; try { "
                        + body
                        + " } catch (Throwable e) { found = \"\" + e; }\n"
                        + "throw new RuntimeException(found);\n");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("neighbors")
    void findsNoNeighbor(String said, String body) throws Exception {
        try (Child neighbor = unscanned.child(ChildKind.RUN)) {
            String code = body.replace("NEIGHBOR", "" + neighbor.handle().pid());
            String thrown = unscanned.draw(telling(code)).thrown();
            assertTrue(thrown.matches("(?s)java.lang.RuntimeException: " + said), thrown);
            assertTrue(neighbor.isAlive(), "the neighbor was ended");
        }
    }

    static Stream<Arguments> neighbors() {
        return Stream.of(
                argumentSet(
                        "counts the processes",
                        "([012]|.*Unable to open /proc.*)",
                        "found += ProcessHandle.allProcesses().count();"),
                argumentSet(
                        "ends another student's process by its number",
                        "Optional.empty",
                        "var other = ProcessHandle.of(NEIGHBORL);"
                                + " other.ifPresent(ProcessHandle::destroyForcibly); found += other;"),
                argumentSet(
                        "ends the first process of the box, outside of which it would be the system's",
                        "(Optional.empty|true|false|.*Exception.*)",
                        "var one = ProcessHandle.of(1);"
                                + " found += one.isEmpty() ? one : one.get().destroyForcibly();"),
                argumentSet(
                        "reads the environment of another process",
                        ".*NoSuchFile.*",
                        "found += java.nio.file.Files.readString("
                                + "java.nio.file.Path.of(\"/proc/NEIGHBOR/environ\"));"));
    }

    @ParameterizedTest(name = "two boxes agree by a file in {0}")
    @ValueSource(strings = {"/tmp", "/dev/shm", "/dev/mqueue", "/run", "/var/tmp", "/box"})
    void nothingIsLeftForTheNext(String folder) throws Exception {
        String write =
                "java.nio.file.Files.writeString(java.nio.file.Path.of(\"%s/left\"), \"x\"); found = \"written\";"
                        .formatted(folder);
        String thrown = unscanned.draw(telling(write)).thrown();
        assertTrue(thrown.matches("(?s).*(NoSuchFile|FileSystem|AccessDenied).*"), thrown);
    }

    @ParameterizedTest(name = "{argumentSetName} takes the server's threads, or outlives its call")
    @MethodSource("bombs")
    void aBombOfThreadsEndsWithItsCall(String bomb) throws Exception {
        int before = Thread.activeCount();
        ProcessHandle process;
        try (Child runner = unscanned.child(ChildKind.RUN)) {
            process = runner.handle();
            String ended;
            try {
                ended = unscanned.draw(runner, method(bomb + "while (true);\n")).thrown();
            } catch (ChildLost lost) {
                ended = "" + lost.reason();
                assertFalse(runner.isAlive(), "the child outlived its loss");
            }
            assertTrue(ended.matches("TIME|MEMORY|.*unable to create native thread.*"), ended);
        }
        assertFalse(process.isAlive(), "the bomb outlived its call");
        assertEquals("", unscanned.draw(method("out.plot(x0, y0);\n")).thrown());
        assertTrue(Thread.activeCount() <= before + 4, () -> Thread.activeCount() + " threads");
    }

    static Stream<Arguments> bombs() {
        return Stream.of(
                argumentSet(
                        "a bomb of 5,000 threads",
                        "for (int i = 0; i < 5_000; i++) new Thread(() -> {"
                                + " while (true) try { Thread.sleep(100_000); }"
                                + " catch (InterruptedException e) { } }).start();\n"),
                argumentSet(
                        "a bomb of threads that start more",
                        "class Bomb extends Thread { public void run() {"
                                + " while (true) try { new Bomb().start(); }"
                                + " catch (Throwable e) { } } }\n"
                                + "new Bomb().start();\n"),
                argumentSet(
                        "a bomb of threads that start another as they end",
                        "class Heir extends Thread { public void run() { new Heir().start(); } }\n"
                                + "for (int i = 0; i < 50; i++) new Heir().start();\n"));
    }
}
