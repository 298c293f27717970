package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Comparator;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.line.ExactLine;
import rasterlab.exercises.child.RunMain;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Request;

/** A method that got past the byte-code check can do nothing to the parent but lose. */
@Tag("slow")
class ChildTest {
    private static Unscanned unscanned;

    @BeforeAll
    static void start() {
        unscanned = new Unscanned(JudgeSettings.Protection.PROCESS_LIMITS_ONLY);
    }

    @AfterAll
    static void end() {
        unscanned.close();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("tricks")
    void isLostWith(ChildLost.LossReason reason, String body) throws Exception {
        try (Child runner = unscanned.child(ChildKind.RUN)) {
            ChildLost lost =
                    assertThrows(
                            ChildLost.class, () -> unscanned.draw(runner, method(guarded(body))));
            assertEquals(reason, lost.reason(), lost::getMessage);
            assertFalse(runner.isAlive(), "the child outlived its loss");
        }
    }

    private static String guarded(String body) {
        return "try { " + body + " } catch (Exception e) { throw new RuntimeException(e); }\n";
    }

    static Stream<Arguments> tricks() {
        String out =
                "java.io.OutputStream raw = new java.io.FileOutputStream(java.io.FileDescriptor.out);";
        return Stream.of(
                argumentSet("exits", ChildLost.LossReason.ENDED, "System.exit(0);"),
                argumentSet(
                        "exits in a static initialiser",
                        ChildLost.LossReason.ENDED,
                        "class Late { static int zero = Integer.signum(0);"
                                + " static { if (zero == 0) System.exit(0); } } new Late();"),
                argumentSet("halts", ChildLost.LossReason.ENDED, "Runtime.getRuntime().halt(0);"),
                argumentSet(
                        "ends as if it were killed",
                        ChildLost.LossReason.SIGNAL,
                        "Runtime.getRuntime().halt(137);"),
                argumentSet(
                        "shutdown hook loops",
                        ChildLost.LossReason.TIME,
                        "Runtime.getRuntime().addShutdownHook("
                                + "new Thread(() -> { while (true); })); System.exit(0);"),
                argumentSet("sleeps", ChildLost.LossReason.TIME, "Thread.sleep(100_000);"),
                argumentSet(
                        "closes stdout",
                        ChildLost.LossReason.PROTOCOL,
                        out + "raw.close(); while (true);"),
                argumentSet(
                        "forges a frame without the nonce",
                        ChildLost.LossReason.PROTOCOL,
                        out
                                + "raw.write(new byte[] {0,0,0,15, 1,2,3,4,5,6,7,8, 0, 0,0,0,0, 0,0});"
                                + "raw.flush();"),
                argumentSet(
                        "announces 2 GB",
                        ChildLost.LossReason.PROTOCOL,
                        out
                                + "raw.write(new byte[] {127, -1, -1, -1}); raw.flush(); while (true);"),
                argumentSet(
                        "sends half a frame",
                        ChildLost.LossReason.ENDED,
                        out + "raw.write(new byte[] {0, 0, 0, 9, 1}); System.exit(0);"),
                argumentSet(
                        "floods stdout with frames",
                        ChildLost.LossReason.PROTOCOL,
                        out + "while (true) raw.write(new byte[] {0, 0, 0, 1, 1});"),
                argumentSet(
                        "starts a thread that exhausts memory",
                        ChildLost.LossReason.MEMORY,
                        "new Thread(() -> { var all = new java.util.ArrayList<long[]>();"
                                + " while (true) all.add(new long[1 << 20]); }).start();"
                                + " Thread.sleep(10_000);"));
    }

    @Test
    void anExceptionThatExitsWhereItIsToldIsNamed() throws Exception {
        String evil =
                "throw new Error() { public String getMessage() { System.exit(0); return null; } };";
        assertEquals("Mine$1", unscanned.draw(method(evil + "\n")).thrown());
    }

    @Test
    void aKilledChildIsToldApartFromOneThatEnded() throws Exception {
        try (Child child = unscanned.child(ChildKind.RUN)) {
            child.handle().destroyForcibly();
            ChildLost lost =
                    assertThrows(
                            ChildLost.class,
                            () ->
                                    child.ask(
                                            new Request(Wire.PING, out -> {}),
                                            Duration.ofMinutes(2),
                                            (status, in) -> status));
            assertEquals(ChildLost.LossReason.SIGNAL, lost.reason(), lost::getMessage);
        }
    }

    @Test
    void aChildThatStopsReadingHoldsNobodyUp() throws Exception {
        byte[] big = new byte[3 << 20];
        try (Child child = unscanned.child(ChildKind.RUN)) {
            ChildLost lost =
                    assertThrows(
                            ChildLost.class,
                            () -> {
                                unscanned.draw(child, method("while (true);\n"));
                                child.ask(
                                        new Request(Wire.LOAD, out -> out.write(big)),
                                        Duration.ofSeconds(5),
                                        (status, in) -> status);
                            });
            assertEquals(ChildLost.LossReason.TIME, lost.reason(), lost::getMessage);
        }
    }

    @ParameterizedTest(name = "{argumentSetName} keeps it from answering")
    @MethodSource("errorStreams")
    void answersInSpiteOf(String body) throws Exception {
        String raw =
                "java.io.OutputStream raw = new java.io.FileOutputStream(java.io.FileDescriptor.err);";
        assertEquals("", unscanned.draw(method(guarded(raw + body))).thrown());
    }

    static Stream<Arguments> errorStreams() {
        return Stream.of(
                argumentSet(
                        "a megabyte on the standard error of the process",
                        "raw.write(new byte[1 << 20]);"),
                argumentSet("the standard error of the process, closed,", "raw.close();"));
    }

    /** A read that waits may still take what comes next, so it is asked more than once. */
    @Test
    void aChildThatClosedItsInputHoldsNobodyUp() throws Exception {
        String close = "new java.io.FileInputStream(java.io.FileDescriptor.in).close();";
        try (Child child = unscanned.child(ChildKind.RUN)) {
            ChildLost lost =
                    assertThrows(
                            ChildLost.class,
                            () -> {
                                unscanned.draw(child, method(guarded(close)));
                                for (int i = 0; i < 3; i++)
                                    child.ask(
                                            new Request(Wire.PING, out -> {}),
                                            Duration.ofMinutes(2),
                                            (status, in) -> status);
                            });
            assertNotEquals(ChildLost.LossReason.TIME, lost.reason(), lost::getMessage);
            assertFalse(child.isAlive(), "the child outlived its loss");
        }
    }

    @ParameterizedTest(name = "{argumentSetName} is on the class path of the student")
    @MethodSource("ours")
    void isNotOnTheStudentsClassPath(Class<?> ours) throws Exception {
        String load = "Class.forName(\"%s\");".formatted(ours.getName());
        assertEquals(
                "java.lang.RuntimeException: java.lang.ClassNotFoundException: " + ours.getName(),
                unscanned.draw(method(guarded(load))).thrown());
    }

    static Stream<Arguments> ours() {
        return Stream.of(
                argumentSet("the harness", RunMain.class),
                argumentSet("the reference solution", ExactLine.class));
    }

    @Test
    void theEnvironmentIsEmpty() throws Exception {
        String names =
                "var names = new java.util.TreeSet<>(System.getenv().keySet());"
                        + " names.removeIf(one -> !one.matches(\"PATH|(JAVA|_JAVA|JDK).*\"));"
                        + " throw new IllegalStateException(\"\" + names);\n";
        assertEquals("java.lang.IllegalStateException: []", unscanned.draw(method(names)).thrown());
    }

    @Test
    void aChildStartsAfterTheFolderWasTakenAway() throws Exception {
        try (Unscanned own = new Unscanned(JudgeSettings.Protection.STRONGEST)) {
            removeAll(own.jars.folder());
            assertEquals("", own.draw(method("out.plot(0, 0);\n")).thrown());
        }
    }

    private static void removeAll(Path top) throws IOException {
        try (Stream<Path> all = Files.walk(top)) {
            for (Path one : all.sorted(Comparator.reverseOrder()).toList()) Files.delete(one);
        }
    }
}
