package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.runner.process.Programs;

/** Runs methods that got past the byte-code check inside bubblewrap. */
@Tag("slow")
class BubblewrapTest {
    private static Unscanned unscanned;

    @BeforeAll
    static void start() {
        assumeTrue(Programs.onPath("bwrap").isPresent(), "bubblewrap is missing");
        unscanned = new Unscanned(JudgeSettings.Protection.STRONGEST);
        assertEquals(
                "bubblewrap",
                unscanned.box.isolation().name(),
                () -> unscanned.box.isolation().describe("en"));
    }

    @AfterAll
    static void end() {
        if (unscanned != null) unscanned.close();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("reaches")
    void findsNothing(String said, String body) throws Exception {
        String source =
                method(
                        "String found; try { "
                                + body
                                + " } catch (Exception e) { found = \"\" + e; }\n"
                                + "throw new RuntimeException(found);\n");
        String thrown = unscanned.draw(source).thrown();
        assertTrue(thrown.matches("(?s)java.lang.RuntimeException: " + said), thrown);
    }

    static Stream<Arguments> reaches() {
        String list = "found = java.util.Arrays.toString(new java.io.File(\"%s\").list());";
        String write =
                "java.nio.file.Files.writeString(java.nio.file.Path.of(\"%s\"), \"x\"); found = \"written\";";
        String connect = "new java.net.Socket(\"%s\", %d); found = \"connected\";";
        return Stream.of(
                argumentSet(
                        "password file",
                        ".*NoSuchFile.*",
                        "found = java.nio.file.Files.readString(java.nio.file.Path.of(\"/etc/passwd\"));"),
                argumentSet("home folders", "null", list.formatted("/home")),
                argumentSet(
                        "folder in which the server runs",
                        "null",
                        list.formatted(Path.of("").toAbsolutePath())),
                argumentSet(
                        "pipe to the judge by its number",
                        ".*NoSuchFile.*",
                        write.formatted("/proc/self/fd/1")),
                argumentSet(
                        "options of Java in the environment",
                        "\\[(PWD|LD_ORIGIN_PATH|, )*\\]",
                        "found = \"\" + System.getenv().keySet();"),
                argumentSet("other processes", "null", list.formatted("/proc")),
                argumentSet(
                        "box holds more than two jars",
                        "\\[(harness.jar, contract.jar|contract.jar, harness.jar)\\]",
                        list.formatted("/box")),
                argumentSet("writes to the root", ".*FileSystem.*", write.formatted("/a")),
                argumentSet("writes to the box", ".*FileSystem.*", write.formatted("/box/a")),
                argumentSet("writes to /dev", ".*FileSystem.*", write.formatted("/dev/a")),
                argumentSet("writes to /dev/shm", ".*FileSystem.*", write.formatted("/dev/shm/a")),
                argumentSet(
                        "a million small files",
                        ".*(NoSuchFile|FileSystem|AccessDenied).*",
                        "for (int i = 0; i < 1_000_000; i++)"
                                + " java.nio.file.Files.createTempFile(\"a\", \"\"); found = \"made\";"),
                argumentSet(
                        "maps a new file into memory",
                        ".*Read-only file system.*",
                        "new java.io.RandomAccessFile(\"/box/a\", \"rw\").getChannel().map("
                                + "java.nio.channels.FileChannel.MapMode.READ_WRITE, 0, 1 << 30);"
                                + " found = \"mapped\";"),
                argumentSet(
                        "leaves a link where its jars are",
                        ".*FileSystem.*",
                        "java.nio.file.Files.createSymbolicLink(java.nio.file.Path.of(\"/box/a\"),"
                                + " java.nio.file.Path.of(\"/etc\")); found = \"linked\";"),
                argumentSet("network", ".*not permitted.*", connect.formatted("192.0.2.1", 80)),
                argumentSet(
                        "another program on this machine by its port",
                        ".*not permitted.*",
                        connect.formatted("127.0.0.1", 1)),
                argumentSet(
                        "database on this machine",
                        ".*not permitted.*",
                        connect.formatted("127.0.0.1", 5432)),
                argumentSet(
                        "metadata of a machine in a cloud",
                        ".*not permitted.*",
                        connect.formatted("169.254.169.254", 80)),
                argumentSet(
                        "a datagram",
                        ".*not permitted.*",
                        "new java.net.DatagramSocket(); found = \"opened\";"),
                argumentSet(
                        "another program on this machine by its socket",
                        ".*not permitted.*",
                        "java.nio.channels.SocketChannel.open(java.net.StandardProtocolFamily.UNIX);"
                                + " found = \"opened\";"),
                argumentSet(
                        "a port of its own",
                        ".*not permitted.*",
                        "new java.net.ServerSocket(0); found = \"listens\";"),
                argumentSet(
                        "network card",
                        ".*not permitted.*",
                        "int up = 0; for (var one : java.util.Collections.list("
                                + "java.net.NetworkInterface.getNetworkInterfaces()))"
                                + " if (!one.isLoopback()) up++; found = \"\" + up;"),
                argumentSet(
                        "starts a program",
                        ".*(Cannot run|No such file|spawn).*",
                        "new ProcessBuilder(\"/bin/ls\").start(); found = \"started\";"),
                argumentSet(
                        "starts Java once more",
                        ".*(Cannot run|No such file|spawn).*",
                        "new ProcessBuilder(System.getProperty(\"java.home\") + \"/bin/java\").start();"
                                + " found = \"started\";"));
    }
}
