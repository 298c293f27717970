package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.time.Duration;
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
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.score.Report;

/** Attacks by their names: as they are refused, and as they end where nothing refused them. */
@Tag("slow")
class AttackNamesTest {
    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    /** An endless call is stopped as well after less processor time. */
    @RegisterExtension
    static final StartedJudge STRICT =
            new StartedJudge(
                    OtherSettings.withCallLimit(
                            Duration.ofMillis(500),
                            JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF)));

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
                argumentSet(
                        "object that reads itself",
                        "the class java.io.ObjectInputStream is",
                        Sources.RIGHT
                                + "class G implements java.io.Serializable {"
                                + " private void readObject(java.io.ObjectInputStream in) { } }\n"),
                used(
                        "private members made accessible",
                        "java.lang.Class.getDeclaredMethods",
                        "getClass().getDeclaredMethods()[0].setAccessible(true);"));
    }

    static Stream<Arguments> classes() {
        return Stream.of(
                type(
                        "shutdown hook",
                        "java.lang.Runtime",
                        "Runtime.getRuntime().addShutdownHook(null);"),
                type(
                        "thread that outlives its call",
                        "java.lang.Thread",
                        "new Thread(() -> { while (true); }).start();"),
                type("sleep that makes it look steady", "java.lang.Thread", "Thread.sleep(1);"),
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
                        "lambda factory called by hand",
                        "java.lang.invoke.LambdaMetafactory",
                        "java.lang.invoke.LambdaMetafactory.metafactory("
                                + "null, null, null, null, null, null);"),
                type(
                        "memory by its address",
                        "sun.misc.Unsafe",
                        "sun.misc.Unsafe.getUnsafe().allocateMemory(1);"),
                type(
                        "agent that changes classes",
                        "java.lang.instrument.Instrumentation",
                        "java.lang.instrument.Instrumentation i = null; i.getAllLoadedClasses();"),
                type(
                        "class made of bytes",
                        "java.lang.ClassLoader",
                        "new ClassLoader() { void make() { defineClass(\"A\", new byte[0], 0, 0); }"
                                + " }.make();"),
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

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource({"greedy", "hidden"})
    void isAnsweredWith(String verdict, String said, String source) throws Exception {
        HostileSourcesTest.assertAnswer(verdict, said, STRICT.grade(source));
    }

    static Stream<Arguments> greedy() {
        String hog = "{ var all = new java.util.ArrayList<long[]>(); while (true) all.add(%s); }\n";
        String filled = hog.formatted("new long[1 << 20]");
        return Stream.of(
                argumentSet(
                        "endless loop that goes on in its finally block",
                        "time_limit",
                        "no answer",
                        method("while (true) try { x0 = 1 / (y0 - y0); } finally { continue; }\n")),
                argumentSet("heap filled", "memory_limit", "out of memory", method(filled)),
                argumentSet(
                        "heap filled where the object is printed, compared or hashed",
                        "ok",
                        "",
                        Sources.RIGHT.replace(
                                "public void",
                                "public int hashCode() "
                                        + filled
                                        + "public boolean equals(Object o) { return hashCode() == 0; }\n"
                                        + "public String toString() { return \"\" + hashCode(); }\n"
                                        + "public void")),
                argumentSet(
                        "recursion whose overflow is caught in a loop",
                        "time_limit",
                        "no answer",
                        method(
                                "while (true) try { draw(x0, y0, x1, y1, out); }"
                                        + " catch (StackOverflowError e) { }\n")),
                argumentSet(
                        "endless print to the standard error",
                        "output_limit",
                        "too much output",
                        method("while (true) System.err.print(\"xxxxxxxxxxxxxxxxxxxxxxx\");\n")),
                argumentSet(
                        "printStackTrace loops",
                        "runtime_error",
                        "Mine$1: late",
                        method(
                                "throw new RuntimeException(\"late\")"
                                        + " { public void printStackTrace() { while (true); } };\n")));
    }

    static Stream<Arguments> hidden() {
        return Stream.of(
                argumentSet(
                        "class called as one of the harness",
                        "ok",
                        "",
                        Sources.RIGHT + "class RunMain { }\nclass Wire { }\n"),
                argumentSet(
                        "memory of a module that is being tried out",
                        "compile_error",
                        "jdk.incubator.foreign",
                        method("jdk.incubator.foreign.MemorySegment memory = null;\n")),
                argumentSet(
                        "call hidden in Unicode escapes",
                        "refused",
                        "5:0 java.lang.System.exit",
                        method("\\u0053ystem.ex\\u0069t(0);\n")));
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
                argumentSet(
                        "deadlock of two threads",
                        "Object a = new Object(), b = new Object();"
                                + " var both = new java.util.concurrent.CountDownLatch(2);"
                                + " new Thread(() -> { synchronized (a) { both.countDown();"
                                + " try { both.await(); } catch (InterruptedException e) { }"
                                + " synchronized (b) { } } }).start();"
                                + " synchronized (b) { both.countDown(); both.await();"
                                + " synchronized (a) { } }"),
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
    @DisplayName("direct buffers outside of the heap are given without end")
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

    /** 100,000 classes take about 15 MB of the heap and twice the limit of their own memory. */
    @Test
    @DisplayName("memory for classes that are made at run time is given without end")
    void memoryForClassesIsLimited() {
        String hog =
                """
                class Maker extends ClassLoader {
                    void make(int number) throws java.io.IOException {
                        var bytes = new java.io.ByteArrayOutputStream();
                        var out = new java.io.DataOutputStream(bytes);
                        out.writeInt(0xCAFEBABE);
                        out.writeInt(52);
                        out.writeShort(5);
                        out.write(new byte[] {7, 0, 2, 1});
                        out.writeUTF("C" + number);
                        out.write(new byte[] {7, 0, 4, 1});
                        out.writeUTF("java/lang/Object");
                        out.write(new byte[] {0, 32, 0, 1, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0});
                        defineClass(null, bytes.toByteArray(), 0, bytes.size());
                    }
                }
                Maker maker = new Maker();
                for (int i = 0; i < 100_000; i++) maker.make(i);
                """;
        ChildLost lost =
                assertThrows(
                        ChildLost.class,
                        () ->
                                unscanned.draw(
                                        method(guarded(hog)),
                                        TimeLimit.wall(Duration.ofMinutes(2))));
        assertEquals(ChildLost.LossReason.MEMORY, lost.reason(), lost::getMessage);
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
    @DisplayName("100,000 errors fill the page")
    void errorsAreCutOff() throws Exception {
        Report report = JUDGE.gradeInChildren(method("x;".repeat(100_000)));
        assertEquals("compile_error", report.verdict().code());
        assertTrue(report.diagnostics().toString().length() <= 10_000, "a text is not cut");
        assertTrue(report.diagnostics().size() <= 21, () -> "" + report.diagnostics().size());
    }

    @Test
    @DisplayName("a class of its own may not be called as one of Java's")
    void namesOfJavasClassesAreFree() throws Exception {
        Report report = JUDGE.grade(Sources.RIGHT + "class Integer { }\nclass Point { }\n");
        assertEquals("ok", report.verdict().code(), report.diagnostics()::toString);
    }
}
