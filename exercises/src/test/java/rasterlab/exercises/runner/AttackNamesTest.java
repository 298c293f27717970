package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Sources;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.score.Report;

/** Attacks by their names: as they are refused, and as they end where nothing refused them. */
@Tag("slow")
class AttackNamesTest {
    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    private static Unscanned unscanned;

    @BeforeAll
    static void start() {
        unscanned = new Unscanned(JudgeSettings.Protection.STRONGEST);
    }

    @AfterAll
    static void end() {
        unscanned.close();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource({"members", "classes"})
    void isRefused(String said, String source) throws Exception {
        Report report = JUDGE.grade(source);
        assertEquals("refused", report.verdict().code(), report.diagnostics()::toString);
        assertEquals(0, report.points().total());
        assertTrue(report.diagnostics().toString().contains(said), report.diagnostics()::toString);
    }

    static Stream<Arguments> members() {
        return Stream.of(
                argumentSet(
                        "System.exit in a static initialiser",
                        "java.lang.System.exit",
                        Sources.RIGHT.replace(
                                "public void",
                                "static { if (Math.abs(1) > 0) System.exit(0); }\npublic void")),
                used("read of standard input", "java.lang.System.in", "System.in.read();"),
                used(
                        "wait that nobody ends",
                        ".wait",
                        "Object o = new Object(); synchronized (o) { o.wait(); }"),
                used("library of machine code", "java.lang.System.load", "System.load(\"/a\");"),
                used("environment", "java.lang.System.getenv", "System.getenv();"),
                used(
                        "private members made accessible",
                        "java.lang.Class.getDeclaredMethods",
                        "getClass().getDeclaredMethods()[0].setAccessible(true);"));
    }

    static Stream<Arguments> classes() {
        return Stream.of(
                type(
                        "park that nobody ends",
                        "java.util.concurrent.locks.LockSupport",
                        "java.util.concurrent.locks.LockSupport.park();"),
                type(
                        "uncaught-exception handler",
                        "java.lang.Thread",
                        "Thread.setDefaultUncaughtExceptionHandler((t, e) -> { });"),
                type(
                        "end of the own process by its handle",
                        "java.lang.ProcessHandle",
                        "ProcessHandle.current().destroyForcibly();"),
                type(
                        "memory outside of the heap",
                        "java.nio.ByteBuffer",
                        "java.nio.ByteBuffer.allocateDirect(1 << 30);"),
                type(
                        "method handles",
                        "java.lang.invoke.MethodHandles",
                        "java.lang.invoke.MethodHandles.lookup();"),
                type(
                        "hidden class",
                        "java.lang.invoke.MethodHandles$Lookup",
                        "java.lang.invoke.MethodHandles.Lookup l = null;"
                                + " l.defineHiddenClass(new byte[0], true);"),
                type(
                        "variable handles",
                        "java.lang.invoke.VarHandle",
                        "java.lang.invoke.VarHandle.fullFence();"),
                type(
                        "class loader of its own",
                        "java.lang.ClassLoader",
                        "class L extends ClassLoader { } new L();"),
                type(
                        "service loader",
                        "java.util.ServiceLoader",
                        "java.util.ServiceLoader.load(Runnable.class);"),
                type(
                        "deserialisation",
                        "java.io.ObjectInputStream",
                        "new java.io.ObjectInputStream(null).readObject();"),
                type("cleaner", "java.lang.ref.Cleaner", "java.lang.ref.Cleaner.create();"),
                type(
                        "phantom reference",
                        "java.lang.ref.PhantomReference",
                        "new java.lang.ref.PhantomReference<Object>(new Object(), null);"),
                type("stack walk", "java.lang.StackWalker", "StackWalker.getInstance();"),
                type(
                        "name of the thread that calls",
                        "java.lang.Thread",
                        "Thread.currentThread().getName();"));
    }

    private static Arguments type(String attack, String type, String code) {
        return used(attack, "the class " + type.replace('$', '.') + " is", code);
    }

    private static Arguments used(String attack, String said, String code) {
        return argumentSet(attack, said, method(guarded(code)));
    }

    private static String guarded(String code) {
        return "try { " + code + " } catch (Exception e) { }\n";
    }

    @ParameterizedTest(name = "{argumentSetName}, past the check")
    @MethodSource("waiting")
    void isStopped(String code) throws Exception {
        try (Child runner = unscanned.child(ChildKind.RUN)) {
            ChildLost lost =
                    assertThrows(
                            ChildLost.class, () -> unscanned.draw(runner, method(guarded(code))));
            assertEquals(ChildLost.LossReason.TIME, lost.reason(), lost::getMessage);
            assertFalse(runner.isAlive(), "the child outlived its loss");
        }
    }

    static Stream<Arguments> waiting() {
        return Stream.of(
                argumentSet(
                        "wait that nobody ends",
                        "Object o = new Object(); synchronized (o) { o.wait(); }"),
                argumentSet(
                        "park that nobody ends",
                        "while (true) java.util.concurrent.locks.LockSupport.park();"),
                argumentSet("read of standard input", "while (true) System.in.read(new byte[9]);"));
    }

    @Test
    @DisplayName("a thread that was leaked outlives the grading")
    void aLeakedThreadDiesWithItsChild() throws Exception {
        String leak =
                "Thread t = new Thread(() -> { while (true); }); t.start(); out.plot(x0, y0);\n";
        Child runner = unscanned.child(ChildKind.RUN);
        assertEquals("", unscanned.draw(runner, method(leak)).thrown());
        ProcessHandle process = runner.handle();
        runner.close();
        assertFalse(process.isAlive());
    }

    @Test
    @DisplayName("memory outside of the heap is given without end")
    void memoryOutsideOfTheHeapIsLimited() throws Exception {
        String hog = "java.nio.ByteBuffer.allocateDirect(64 << 20);\n";
        String thrown;
        try {
            thrown = unscanned.draw(method(hog)).thrown();
        } catch (ChildLost lost) {
            thrown = lost.reason() == ChildLost.LossReason.MEMORY ? "OutOfMemoryError" : "" + lost;
        }
        assertTrue(thrown.contains("OutOfMemoryError"), thrown);
    }

    @Test
    @DisplayName("an annotation processor in the source runs in the compiler")
    void noProcessorRuns() throws Exception {
        String processor =
                Sources.RIGHT
                        + """
                        @javax.annotation.processing.SupportedAnnotationTypes("*")
                        class P extends javax.annotation.processing.AbstractProcessor {
                            public boolean process(
                                    java.util.Set<? extends javax.lang.model.element.TypeElement> a,
                                    javax.annotation.processing.RoundEnvironment r) {
                                while (true);
                            }
                        }
                        """;
        Report report = JUDGE.gradeInChildren(processor);
        assertTrue(
                report.verdict().code().matches("refused|compile_error"),
                report.diagnostics()::toString);
        assertTrue(
                report.diagnostics().toString().contains("javax.annotation.processing"),
                report.diagnostics()::toString);
    }

    @Test
    @DisplayName("60,000 errors fill the page")
    void errorsAreCutOff() throws Exception {
        Report report = JUDGE.gradeInChildren(method("x;\n".repeat(60_000)));
        assertEquals("compile_error", report.verdict().code());
        assertTrue(report.diagnostics().size() <= 21, () -> "" + report.diagnostics().size());
    }

    @Test
    @DisplayName("a class of its own may not be called as one of Java's")
    void namesOfJavasClassesAreFree() throws Exception {
        Report report = JUDGE.grade(Sources.RIGHT + "class Integer { }\nclass Point { }\n");
        assertEquals("ok", report.verdict().code(), report.diagnostics()::toString);
    }
}
