package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.score.Answer;

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

    @Test
    void theHarnessIsNotOnTheStudentsClassPath() throws Exception {
        Answer answer =
                unscanned.draw(
                        method(guarded("Class.forName(\"rasterlab.exercises.child.RunMain\");")));
        assertEquals(
                "java.lang.RuntimeException: java.lang.ClassNotFoundException:"
                        + " rasterlab.exercises.child.RunMain",
                answer.thrown());
    }

    @Test
    void theEnvironmentIsEmpty() throws Exception {
        Answer answer =
                unscanned.draw(
                        method("throw new RuntimeException(\"\" + System.getenv(\"PATH\"));\n"));
        assertEquals("java.lang.RuntimeException: null", answer.thrown());
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
