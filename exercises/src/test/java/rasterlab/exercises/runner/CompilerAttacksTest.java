package rasterlab.exercises.runner;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.util.Collections;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.Report;

/** Attacks on the compiler and by the names of classes end with an answer, in bounded time. */
@Tag("slow")
class CompilerAttacksTest {
    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource({"blowUps", "names"})
    void isAnsweredFromAChildWith(String verdict, String said, String source) throws Exception {
        Report report = JUDGE.gradeInChildren(source);
        String told = report.diagnostics().toString();
        assertEquals(verdict, report.verdict().code(), told);
        assertTrue(told.contains(said), told);
    }

    static Stream<Arguments> blowUps() {
        String inferred =
                "id(".repeat(60)
                        + "x0"
                        + ")".repeat(60)
                        + ";\n}\n<T, R extends java.util.List<? super T>> R id(T of) { return null;";
        String diamonds =
                IntStream.range(0, 22)
                                .mapToObj(i -> "pair(() -> ")
                                .collect(
                                        joining("", "Object o = ", "1" + ")".repeat(22) + ";\n}\n"))
                        + "<T> T pair(java.util.function.Supplier<T> one) { return one.get(); }\n"
                        + "<T> T pair(java.util.concurrent.Callable<T> one) { return null;";
        return Stream.of(
                argumentSet(
                        "20,000 nested parentheses",
                        "compile_error",
                        "too complex",
                        method(
                                "int a = "
                                        + "(".repeat(20_000)
                                        + "x0"
                                        + ")".repeat(20_000)
                                        + ";\n")),
                argumentSet(
                        "24 nested finally blocks double the code 24 times",
                        "compile_error",
                        "too complex",
                        method(
                                String.join("", Collections.nCopies(24, "try { x0++; } finally { "))
                                        + "}".repeat(24))),
                argumentSet(
                        "a constant text doubled 30 times",
                        "compile_error",
                        "too complex",
                        method(doubledTexts(30))),
                argumentSet(
                        "60 nested calls whose types are inferred", "wrong", "", method(inferred)),
                argumentSet(
                        "22 nested lambdas for two overloads",
                        "compile_error",
                        "reference to pair is ambiguous",
                        method(diamonds)));
    }

    private static String doubledTexts(int times) {
        return IntStream.rangeClosed(1, times)
                .mapToObj(i -> "final String s%d = s%d + s%2$d;\n".formatted(i, i - 1))
                .collect(joining("", "final String s0 = \"" + "x".repeat(100) + "\";\n", ""));
    }

    static Stream<Arguments> names() {
        return Stream.of(
                argumentSet(
                        "a package name that leads out of the folder",
                        "compile_error",
                        "illegal '.'",
                        "package ../../etc;\n" + Sources.RIGHT),
                argumentSet(
                        "a class name that leads out of the folder",
                        "compile_error",
                        "",
                        Sources.RIGHT.replace("class Bresenham", "class ../Bresenham")),
                argumentSet(
                        "a class name of 300 characters",
                        "refused",
                        "class names have at most 100 characters",
                        Sources.RIGHT + "class " + "A".repeat(300) + " { }\n"),
                argumentSet(
                        "names of devices of Windows, no file being made of them",
                        "ok",
                        "",
                        Sources.RIGHT + "class CON { }\nclass AUX { }\nclass NUL { }\n"),
                argumentSet(
                        "names that differ in their case alone, no file being made of them",
                        "ok",
                        "",
                        Sources.RIGHT + "class bresenham { }\nclass BRESENHAM { }\n"),
                argumentSet(
                        "words that the compiler would take for options or for a file of arguments",
                        "compile_error",
                        "<identifier> expected",
                        "@/etc/passwd -version -J-Xmx9g\n" + Sources.RIGHT));
    }
}
