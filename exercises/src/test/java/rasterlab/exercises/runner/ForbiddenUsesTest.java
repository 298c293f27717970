package rasterlab.exercises.runner;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.exercises.Sources.method;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/**
 * Each use of what is not allowed is told at its line. All of them stand in one source, a line for
 * each, which is compiled once.
 */
@Tag("slow")
class ForbiddenUsesTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    /** The line of a source in which its method's body begins. */
    private static final int FIRST_LINE = 5;

    private static Report report;

    /**
     * @param message how the message begins
     * @param code in one line
     */
    private record Use(String name, String message, String code) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static final List<Use> USES =
            List.of(
                    new Use("System.exit", "java.lang.System.exit", "System.exit(0);"),
                    new Use("halt", "the class java.lang.Runtime", "Runtime.getRuntime().halt(0);"),
                    new Use(
                            "thread",
                            "the class java.lang.Thread",
                            "new Thread(() -> { }).start();"),
                    new Use("file", "the class java.io.File", "new java.io.File(\"/\").list();"),
                    new Use(
                            "reflection",
                            "java.lang.Class.getDeclaredFields",
                            "getClass().getDeclaredFields();"),
                    new Use(
                            "forName",
                            "java.lang.Class.forName",
                            "try { Class.forName(\"A\"); } catch (Exception e) { }"),
                    new Use(
                            "method handle to exit",
                            "java.lang.System.exit",
                            "java.util.function.IntConsumer c = System::exit; c.accept(0);"),
                    new Use("random", "java.lang.Math.random", "double r = Math.random();"),
                    new Use("nanoTime", "java.lang.System.nanoTime", "long t = System.nanoTime();"),
                    new Use(
                            "parallel stream",
                            "java.util.ArrayList.parallelStream",
                            "new java.util.ArrayList<Integer>().parallelStream().count();"),
                    new Use(
                            "stream made parallel",
                            "java.util.stream.IntStream.parallel",
                            "java.util.stream.IntStream.range(0, 9).parallel().sum();"),
                    new Use(
                            "stream made parallel by a method handle",
                            "java.util.stream.IntStream.parallel",
                            "java.util.function.UnaryOperator<java.util.stream.IntStream> f ="
                                    + " java.util.stream.IntStream::parallel;"),
                    new Use(
                            "class loader by way of getClass",
                            "java.lang.Class.getClassLoader",
                            "Object o = getClass().getClassLoader();"),
                    new Use(
                            "stack trace",
                            "java.lang.Exception.getStackTrace",
                            "int depth = new Exception().getStackTrace().length;"),
                    new Use(
                            "stream closes System.out",
                            "java.io.PrintStream.close",
                            "System.out.close();"),
                    new Use(
                            "file descriptor",
                            "the class java.io.FileDescriptor",
                            "Object o = java.io.FileDescriptor.out;"));

    @BeforeAll
    static void gradeAllTogether() throws Exception {
        report =
                JUDGE.grade(
                        method(
                                USES.stream()
                                        .map(one -> "{ " + one.code + " }\n")
                                        .collect(joining())));
    }

    @Test
    void theSourceIsRefusedWithoutPoints() {
        assertEquals(GradingVerdict.REFUSED, report.verdict(), report.diagnostics()::toString);
        assertEquals(0, report.points().total());
    }

    static Stream<Use> uses() {
        return USES.stream();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("uses")
    void isToldAtItsLine(Use use) {
        int line = FIRST_LINE + USES.indexOf(use);
        assertTrue(
                report.diagnostics().stream()
                        .filter(one -> one.line() == line && one.column() == 0)
                        .map(Diagnostic::message)
                        .anyMatch(message -> message.startsWith(use.message)),
                () -> "nothing in line " + line + " of " + report.diagnostics());
    }
}
