package rasterlab.exercises.runner;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.time.Duration;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/**
 * Each source ends in the verdict and the text that a student can act on. Those that try the
 * compiler are compiled in a child each, as on the server, the others together in this process.
 */
@Tag("slow")
class HostileSourcesTest {
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

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("texts")
    void isAnsweredFromAChildWith(String verdict, String said, String source) throws Exception {
        assertAnswer(verdict, said, JUDGE.gradeInChildren(source));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource({"welcome", "classes", "throwing"})
    void isAnsweredWith(String verdict, String said, String source) throws Exception {
        assertAnswer(verdict, said, JUDGE.grade(source));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("greedy")
    void isStoppedWith(String verdict, String said, String source) throws Exception {
        assertAnswer(verdict, said, STRICT.grade(source));
    }

    /** The verdict, the words, fewer points than for a right method, and no process that stays. */
    static void assertAnswer(String verdict, String said, Report report) {
        assertEquals(verdict, report.verdict().code(), () -> words(report));
        assertEquals(0, ProcessHandle.current().descendants().count(), "processes are left");
        assertTrue(words(report).contains(said), () -> said + " is not in " + words(report));
        if (report.verdict() != GradingVerdict.OK)
            assertTrue(report.points().total() < report.points().of(), () -> words(report));
    }

    private static String words(Report report) {
        return report.diagnostics().stream().map(HostileSourcesTest::place).collect(joining("\n"))
                + report.cases().stream().map(CaseReport::message).collect(joining("\n", "\n", ""));
    }

    private static String place(Diagnostic one) {
        return one.line() + ":" + one.column() + " " + one.message();
    }

    static Stream<Arguments> texts() {
        return Stream.of(
                argumentSet("right solution", "ok", "", Sources.RIGHT),
                argumentSet("naive textbook", "wrong", "naive-textbook", Sources.NAIVE_TEXTBOOK),
                argumentSet(
                        "Bresenham textbook",
                        "wrong",
                        "bresenham-textbook draws the same",
                        Sources.BRESENHAM_TEXTBOOK),
                argumentSet(
                        "type error in line 5",
                        "compile_error",
                        "5:9 incompatible types",
                        method("int a = \"\";\n")),
                argumentSet("empty source", "compile_error", "empty", " \n"),
                argumentSet("byte order mark", "ok", "", '\uFEFF' + Sources.RIGHT),
                argumentSet(
                        "second byte order mark",
                        "compile_error",
                        "1:1 a byte order mark",
                        "\uFEFF\uFEFF" + Sources.RIGHT),
                argumentSet("NUL", "compile_error", "5:1 a NUL", method("\0")),
                argumentSet(
                        "bidi control", "compile_error", "5:4 the invisible", method("// \u202E")),
                argumentSet("lone surrogate", "compile_error", "5:4 half a", method("// \uD800")),
                argumentSet(
                        "lines that end in a carriage return alone",
                        "compile_error",
                        "3:2 half a",
                        "\r\r\n/\uD800"),
                argumentSet(
                        "Kotlin",
                        "compile_error",
                        "4:14 Kotlin is not accepted; send Java",
                        """
                        import rasterlab.contract.*

                        class Mine : LineRasterizer {
                            override fun draw(x0: Int, y0: Int, x1: Int, y1: Int, out: Pixels) =
                                out.plot(x0, y0)
                        }
                        """),
                argumentSet(
                        "a text without a class",
                        "compile_error",
                        "0:0 there is no class here; send one public class",
                        "int x = 3;\n"),
                argumentSet(
                        "a function that the compiler does not find",
                        "compile_error",
                        "5:1 cannot find symbol",
                        method("fun(x0);\n")),
                argumentSet(
                        "20,000 open braces",
                        "compile_error",
                        "too complex",
                        method("{".repeat(20_000))),
                argumentSet(
                        "sum of 60,000 terms",
                        "compile_error",
                        "too complex",
                        method("int a = x0" + " + 1".repeat(60_000) + ";\n")),
                argumentSet(
                        "10 MB source", "refused", "longer than", method("//".repeat(5_000_000))));
    }

    static Stream<Arguments> classes() {
        String rest = Sources.RIGHT.substring(Sources.RIGHT.indexOf("import"));
        return Stream.of(
                argumentSet(
                        "package line", "refused", "1:0 package mine", "package mine;\n" + rest),
                argumentSet(
                        "package line below a comment on packages",
                        "refused",
                        "3:0 package mine",
                        "/* no\npackage */ // package\npackage mine;\n" + rest),
                argumentSet(
                        "package of the harness",
                        "refused",
                        "1:0 package rasterlab.contract",
                        "package rasterlab.contract;\n"
                                + rest.replace("import rasterlab.contract.*;", "")),
                argumentSet(
                        "package of the JDK",
                        "compile_error",
                        "another module: java.base",
                        "package java.lang;\n" + rest),
                argumentSet(
                        "harness class",
                        "compile_error",
                        "does not exist",
                        method("rasterlab.exercises.child.Wire.cut(\"\");\n")),
                argumentSet(
                        "200 classes more than its own",
                        "refused",
                        "too many classes: 201, at most 200 are allowed",
                        Sources.RIGHT + manyClasses(200)),
                argumentSet("199 classes beside it", "ok", "", Sources.RIGHT + manyClasses(199)),
                argumentSet(
                        "class files beyond the longest frame",
                        "refused",
                        "the class files are too long: ",
                        Sources.RIGHT + longClasses()),
                argumentSet(
                        "lattice of interfaces with more ways up than can be walked",
                        "refused",
                        "6:0 Tangled.getStackTrace",
                        method("Tangled t = new Tangled();\nt.getStackTrace();\n")
                                + Sources.latticeOf(10)),
                argumentSet(
                        "program started",
                        "refused",
                        "5:0 the class java.lang.Runtime is",
                        method(
                                "try { Runtime.getRuntime().exec(\"ls\"); }"
                                        + " catch (Exception e) { }\n")),
                argumentSet("no class", "refused", "no public class implements", "class A { }"),
                argumentSet(
                        "two classes",
                        "refused",
                        "exactly one may",
                        Sources.RIGHT + Sources.method("").replaceFirst("import.*\n", "")),
                argumentSet(
                        "constructor with a parameter",
                        "refused",
                        "needs a public constructor",
                        Sources.RIGHT.replace(
                                "public void", "public Bresenham(int a) { }\npublic void")),
                argumentSet(
                        "native method",
                        "refused",
                        "native",
                        Sources.RIGHT.replace("public void", "native void a();\npublic void")),
                argumentSet(
                        "finalizer",
                        "refused",
                        "finalize",
                        Sources.RIGHT.replace(
                                "public void", "protected void finalize() { }\npublic void")),
                argumentSet(
                        "thread as superclass",
                        "refused",
                        "3:0 the class java.lang.Thread is",
                        Sources.RIGHT.replace("implements", "extends Thread implements")),
                argumentSet(
                        "static initialiser loops",
                        "time_limit",
                        "no answer within 2.0 s",
                        Sources.RIGHT.replace(
                                "public void", "static { while (Math.abs(1) > 0); }\npublic void")),
                argumentSet(
                        "lambdas, records, enums and text",
                        "wrong",
                        "pixel (1, 0) is missing",
                        method(
                                "record P(int x, int y) { } enum E { A, B }\n"
                                        + "java.util.List<P> all = new java.util.ArrayList<>();\n"
                                        + "all.add(new P(x0, y0)); String s = E.A + \" \" + all;\n"
                                        + "switch (E.valueOf(\"B\")) { case A -> out.plot(1, 1);\n"
                                        + "  case B -> all.forEach(p -> out.plot(p.x, p.y)); }\n")));
    }

    private static String manyClasses(int number) {
        return IntStream.range(0, number).mapToObj("class C%d { }%n"::formatted).collect(joining());
    }

    /** The compiler adds constant texts up: 40 texts of 60,000 characters from a short source. */
    private static String longClasses() {
        String constants =
                "static final String A = \"%s\", B = A%s;\n"
                        .formatted("x".repeat(1000), " + A".repeat(59));
        return IntStream.range(0, 40)
                .mapToObj("static String c%1$d() { return B + %1$d; }%n"::formatted)
                .collect(joining("", "class Long {\n" + constants, "}\n"));
    }

    /** A source that is welcome: whatever of it was refused would be told with its line. */
    static Stream<Arguments> welcome() {
        String all =
                """
                { var open = new java.util.PriorityQueue<Integer>(); open.add(x0); }
                { var map = new java.util.LinkedHashMap<String, Integer>(); map.put("a", 1);
                  for (java.util.Map.Entry<String, Integer> e : map.entrySet())
                      e.setValue(e.getValue() + e.getKey().length()); }
                { enum E { A, B }
                  var map = new java.util.EnumMap<E, Integer>(E.class);
                  for (E e : E.values()) map.put(e, switch (e) { case A -> 1; case B -> 2; }); }
                { java.util.function.ObjIntConsumer<Pixels> f = (p, i) -> { }; f.accept(out, 1); }
                { var a = java.util.stream.IntStream.range(0, 9).map(i -> i * i).filter(i -> i > 2);
                  var all = java.util.Arrays.stream(a.toArray()).boxed()
                      .collect(java.util.stream.Collectors.toList()); }
                { String s = String.format(java.util.Locale.ROOT, "%d", x0) + System.lineSeparator()
                      + getClass().getSimpleName() + getClass().getName()
                      + new StringBuilder().append(1.5).reverse(); }
                { try { Integer.parseInt("a"); }
                  catch (NumberFormatException e) { e.printStackTrace(); } }
                """;
        return Stream.of(
                argumentSet(
                        "queue, maps, streams, texts and a stack trace",
                        "ok",
                        "",
                        Sources.RIGHT.replace("long dx", all + "long dx")));
    }

    static Stream<Arguments> greedy() {
        String hog =
                "java.util.List<long[]> all = new java.util.ArrayList<>();\n"
                        + "while (true) { try { all.add(new long[1 << 20]); }"
                        + " catch (Throwable e) { } }\n";
        return Stream.of(
                argumentSet("endless loop", "time_limit", "no answer", method("while (true);\n")),
                argumentSet(
                        "endless loop that swallows everything",
                        "time_limit",
                        "not run: your method was stopped in 5 cases before",
                        method(
                                "while (true) try { out.plot(1 / (x0 - x0), 0); }"
                                        + " catch (Throwable e) { }\n")),
                argumentSet(
                        "endless plotting",
                        "output_limit",
                        "still plotting after 1016 pixels where 8 are right",
                        method("while (true) out.plot(x0, y0);\n")),
                argumentSet(
                        "endless plotting that swallows everything",
                        "output_limit",
                        "too much output",
                        method("while (true) try { out.plot(0, 0); } catch (Throwable e) { }\n")),
                argumentSet(
                        "heap filled, the error caught and ignored",
                        "memory_limit",
                        "out of memory",
                        method(hog)),
                argumentSet(
                        "largest array",
                        "memory_limit",
                        "out of memory",
                        method("long[] a = new long[Integer.MAX_VALUE];\n")),
                argumentSet(
                        "huge print in one line",
                        "output_limit",
                        "too much output",
                        method("while (true) System.out.print(\"xxxxxxxxxxxxxxxxxxxxxxx\");\n")),
                argumentSet(
                        "a little print",
                        "wrong",
                        "printed in “the last pixel is drawn”: to (7, 3)",
                        method("System.out.println(\"to (\" + x1 + \", \" + y1 + \")\");\n")));
    }

    static Stream<Arguments> throwing() {
        String evil = "throw new RuntimeException() { public String getMessage() { %s } };\n";
        return Stream.of(
                argumentSet(
                        "division by zero",
                        "runtime_error",
                        "java.lang.ArithmeticException: / by zero; in line 6",
                        method("\nout.plot(x0 / (y0 - y0), 0);\n")),
                argumentSet(
                        "nothing where an array should be",
                        "runtime_error",
                        "because \"row\" is null; in line 5",
                        method("int[] row = null; row[0] = x0;\n")),
                argumentSet(
                        "deep recursion",
                        "runtime_error",
                        "java.lang.StackOverflowError",
                        method("draw(x0, y0, x1, y1, out);\n")),
                argumentSet(
                        "getMessage loops",
                        "runtime_error",
                        "Mine$1",
                        method(evil.formatted("while (true);"))),
                argumentSet(
                        "getMessage of 20 MB",
                        "runtime_error",
                        "aaaa…",
                        method(evil.formatted("return \"a\".repeat(20_000_000);"))),
                argumentSet(
                        "getMessage throws",
                        "runtime_error",
                        "its getMessage() threw java.lang.IllegalStateException",
                        method(evil.formatted("throw new IllegalStateException();"))),
                argumentSet(
                        "message acts on the terminal",
                        "runtime_error",
                        "java.lang.IllegalStateException: \\u001B[2J\\u202E\\nok",
                        method("throw new IllegalStateException(\"\\33[2J\\u202E\\nok\");\n")),
                argumentSet(
                        "cause of an exception loops",
                        "runtime_error",
                        "Mine$1: late",
                        method(
                                "throw new RuntimeException(\"late\")"
                                        + " { public Throwable getCause() { while (true); } };\n")),
                argumentSet(
                        "refuses everything",
                        "runtime_error",
                        "java.lang.IllegalArgumentException: no",
                        method("throw new IllegalArgumentException(\"no\");\n")));
    }
}
