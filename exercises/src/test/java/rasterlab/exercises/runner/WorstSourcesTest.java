package rasterlab.exercises.runner;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.sun.management.ThreadMXBean;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.exercises.Grading;
import rasterlab.exercises.Sources;
import rasterlab.exercises.runner.scan.AllowList;
import rasterlab.exercises.runner.scan.ByteCodeCheck;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;

/**
 * The server's own work on the worst sources of the allowed size, before and after they are
 * compiled, is bounded: by processor time, which does not grow when other programs run, and by all
 * that is allocated, whether it is kept or not.
 */
@Tag("slow")
class WorstSourcesTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final Duration MOST_TIME = Duration.ofSeconds(1);
    private static final long MOST_BYTES = 32 << 20;
    private static final int ALL = Grading.MOST_SOURCE_BYTES;
    private static final ByteCodeCheck CHECK =
            new ByteCodeCheck(AllowList.of(LineRasterizer.class));

    private static final Set<String> KEYWORDS = Set.of(",for", ",int", ",new", ",try");

    private static final DataInputStream NO_ANSWER =
            new DataInputStream(InputStream.nullInputStream());

    private static WarmCompiler compiler;

    /** The cost of looking at a source. */
    private record Cost(List<Diagnostic> diagnostics, Duration time, long bytes) {}

    @BeforeAll
    static void warmUp() throws IOException {
        compiler = new WarmCompiler();
        costOf(Sources.RIGHT);
    }

    @AfterAll
    static void removeJars() {
        compiler.close();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource({"comments", "places", "names", "code", "texts"})
    void costLittle(String said, String source) {
        assertTrue(source.getBytes(StandardCharsets.UTF_8).length <= ALL, "the source is too long");
        // ends the test where the bound is missed by far
        Cost cost = assertTimeoutPreemptively(Duration.ofMinutes(5), () -> costOf(source));
        String words =
                cost.diagnostics().stream()
                        .map(WorstSourcesTest::diagnosticText)
                        .collect(joining("\n"));
        assertTrue(words.contains(said), () -> said + " is not in " + words);
        assertTrue(cost.time().compareTo(MOST_TIME) <= 0, () -> cost.time() + " of the processor");
        assertTrue(cost.bytes() <= MOST_BYTES, () -> (cost.bytes() >> 20) + " MiB were allocated");
    }

    private static String diagnosticText(Diagnostic one) {
        return one.line() + " " + one.message();
    }

    private static Cost costOf(String source) throws IOException {
        boolean compiles = SourceText.faultOf(source).isEmpty();
        try (DataInputStream answer = compiles ? compiler.answer(source) : NO_ANSWER) {
            long bytes = THREADS.getCurrentThreadAllocatedBytes();
            long nanos = THREADS.getCurrentThreadCpuTime();
            List<Diagnostic> said = saidOf(source, answer);
            return new Cost(
                    said,
                    Duration.ofNanos(THREADS.getCurrentThreadCpuTime() - nanos),
                    THREADS.getCurrentThreadAllocatedBytes() - bytes);
        }
    }

    private static List<Diagnostic> saidOf(String source, DataInputStream answer)
            throws IOException {
        var fault = SourceText.faultOf(source);
        if (fault.isPresent()) return List.of(fault.get().diagnostic());
        Compilation compiled = Compilation.of(source, answer.readByte(), answer);
        return compiled.verdict() == GradingVerdict.OK
                ? CHECK.check(compiled.classes(), "rasterlab/contract/LineRasterizer", source)
                        .refusals()
                : compiled.errors();
    }

    static Stream<Arguments> comments() {
        String strings = ("static String s%d = \"" + "/* ".repeat(20_000) + "\";\n");
        String unended =
                IntStream.range(0, 4).mapToObj(i -> String.format(strings, i)).collect(joining());
        return Stream.of(
                argumentSet(
                        "comments that begin in strings and never end",
                        "1 package mine is not allowed",
                        "package mine; class Mine {\n" + unended + "}"),
                argumentSet(
                        "stars in one long comment",
                        "3 package mine",
                        "/*" + "*".repeat(ALL - 100) + "\n\n*/package mine; class Mine {}"),
                argumentSet(
                        "slashes and stars in turn",
                        "2 package mine",
                        "/*" + "/ * ".repeat((ALL - 100) / 4) + "*/\npackage mine; class Mine {}"),
                argumentSet(
                        "60,000 short comments",
                        "1 package mine",
                        "/**/".repeat(60_000) + "package mine; class Mine {}"),
                argumentSet(
                        "Unicode escapes that begin comments",
                        "1 package mine",
                        "\\u002f* package */".repeat(10_000) + "package mine; class Mine {}"),
                argumentSet(
                        "an escape with 200,000 letters u",
                        "1 package mine",
                        "/* \\" + "u".repeat(200_000) + "002a */ package mine; class Mine {}"));
    }

    static Stream<Arguments> places() {
        String lines = "\n".repeat(200_000);
        return Stream.of(
                argumentSet(
                        "20 refused classes after 200,000 empty lines",
                        "200001 the class java.lang.Thread is not allowed",
                        lines
                                + "public class Mine { Thread a; Runtime b; Process c;"
                                + " ProcessBuilder d; ClassLoader e; ThreadGroup f; Module g;"
                                + " ModuleLayer h; StackWalker i; ThreadLocal j; Class k; System l;"
                                + " InheritableThreadLocal m; java.io.File n; java.io.Reader o;"
                                + " java.io.Writer p; java.io.InputStream q; java.net.URL r;"
                                + " java.net.URI s; java.net.Socket t; java.nio.file.Path u; }"),
                argumentSet(
                        "1,500 native methods after 200,000 empty lines",
                        "200001 native is not allowed",
                        lines + "class Mine {" + each(1_500, "native void a%d();") + "}"),
                argumentSet(
                        "words that nearly are refused ones, in one line",
                        "1 the class java.lang.Thread is not allowed",
                        "class Mine { Thread a; int Threa" + each(20_000, ", Threa%d") + "; }"),
                argumentSet(
                        "one refused call 16,000 times in one line",
                        "1 java.lang.System.exit is not allowed",
                        "class Mine { "
                                + each(2, "void a%d() {" + "System.exit(0);".repeat(8_000) + "}")
                                + "}"),
                argumentSet(
                        "refused calls in 8,000 lines",
                        "1 java.lang.System.exit is not allowed",
                        "class Mine { void a() {" + "System.exit(0);\n".repeat(8_000) + "}}"),
                argumentSet(
                        "exceptions in 4,000 lines",
                        "1 the class java.io.IOException is not allowed",
                        "class Mine { void a() {"
                                + "new java.io.IOException().getCause();\n".repeat(4_000)
                                + "}}"));
    }

    static Stream<Arguments> names() {
        return Stream.of(
                argumentSet(
                        "50,000 identifiers",
                        "no public class implements",
                        "class Mine { int a" + identifiers(50_000) + "; }"),
                argumentSet(
                        "a package whose name has 60,000 characters",
                        "1 package aaa",
                        "package " + "a".repeat(60_000) + "; class Mine {}"),
                argumentSet(
                        "a class name of 30,000 characters in 8,000 descriptors",
                        "class names have at most 100 characters",
                        "class Mine<T extends "
                                + "L".repeat(30_000)
                                + "> {"
                                + each(8_000, "void a%d(T b) {}")
                                + "} class "
                                + "L".repeat(30_000)
                                + " {}"),
                argumentSet(
                        "a descriptor of 25,000 characters in 200 methods",
                        "no public class implements",
                        "class Mine<T extends "
                                + "L".repeat(100)
                                + "> {"
                                + each(130, "void a%d(" + each(253, "T a%d,") + "T b) {}")
                                + "} class "
                                + "L".repeat(100)
                                + " {}"),
                argumentSet(
                        "4,096 methods whose names have one hash code",
                        "no public class implements",
                        "class Mine {"
                                + IntStream.range(0, 4096)
                                        .mapToObj(i -> "void " + sameHash(i) + "() {}")
                                        .collect(joining())
                                + "}"),
                argumentSet(
                        "80,000 Cyrillic letters",
                        "no public class implements",
                        "class Mine { int ы;"
                                + each(5, "void я%d() {" + "ы=ы;".repeat(8_000) + "}")
                                + "}"));
    }

    /** Each of three letters and digits, after a comma: in base 36, lower case and then upper. */
    private static String identifiers(int count) {
        return IntStream.range(0, count)
                .mapToObj(WorstSourcesTest::identifier)
                .filter(one -> !KEYWORDS.contains(one))
                .collect(joining());
    }

    private static String identifier(int number) {
        String name = "," + Integer.toString(10 * 36 * 36 + number % 30_000, 36);
        return number < 30_000 ? name : name.toUpperCase(Locale.ROOT);
    }

    private static String sameHash(int number) {
        return IntStream.range(0, 12)
                .mapToObj(bit -> (number >> bit & 1) == 0 ? "Aa" : "BB")
                .collect(joining());
    }

    static Stream<Arguments> code() {
        String name = "n".repeat(5_000);
        String nested =
                IntStream.range(0, 7).mapToObj(i -> "try { a(); } finally {").collect(joining());
        String doubled = nested + name + "++;" + "}".repeat(7);
        return Stream.of(
                argumentSet(
                        "a name of 5,000 characters in the code of nested finally blocks",
                        "no public class implements",
                        "class Mine { int "
                                + name
                                + "; "
                                + each(40, "void a%d() {" + doubled + "}")
                                + " void a() {} }"),
                argumentSet(
                        "a refused call in nested finally blocks",
                        "1 java.lang.System.exit",
                        "class Mine { "
                                + each(
                                        40,
                                        "void a%d() {"
                                                + nested
                                                + "System.exit(0);"
                                                + "}".repeat(7)
                                                + "}")
                                + " void a() {} }"),
                argumentSet(
                        "60 classes, each below the one before",
                        "no public class implements",
                        "class C0 { "
                                + each(4_000, "void a%d() {}")
                                + "}"
                                + IntStream.range(1, 60)
                                        .mapToObj(
                                                i -> "class C" + i + " extends C" + (i - 1) + "{}")
                                        .collect(joining())
                                + "class Mine { void a(C59 c) {"
                                + each(4_000, "c.a%d();")
                                + "}}"));
    }

    static Stream<Arguments> texts() {
        return Stream.of(
                argumentSet("one line of 256 KiB", "", "class Mine {" + "a".repeat(ALL - 20)),
                argumentSet("256 KiB of empty lines", "empty", "\n".repeat(ALL)),
                argumentSet(
                        "a NUL after 256 KiB of lines",
                        (ALL - 20) + " a NUL",
                        "\n".repeat(ALL - 21) + "\0"),
                argumentSet("256 KiB of quotes", "", "\"".repeat(ALL)),
                argumentSet("256 KiB of backslashes", "", "\\".repeat(ALL)),
                argumentSet("256 KiB of round brackets in turn", "", "()".repeat(ALL / 2)),
                argumentSet("256 KiB of semicolons", "no public class", ";".repeat(ALL)),
                argumentSet("85 KiB of wide characters", "", "語".repeat(ALL / 3)));
    }

    private static String each(int count, String format) {
        return IntStream.range(0, count).mapToObj(i -> String.format(format, i)).collect(joining());
    }
}
