package rasterlab.exercises.runner;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.exercises.Sources.method;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** Reads what a student is told where a static initialiser throws. */
@Tag("slow")
class InitializerTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("throwing")
    void whatItThrewIsTold(String said, String source) throws Exception {
        Report report = JUDGE.grade(source);
        assertEquals(GradingVerdict.RUNTIME_ERROR, report.verdict());
        String told = report.cases().stream().map(CaseReport::message).collect(joining("\n"));
        assertTrue(told.contains(said), () -> said + " is not in " + told);
    }

    @Test
    @DisplayName("a class that cannot be loaded gets the points of a refusal")
    void itIsNoRefusal() throws Exception {
        String late =
                "class Late { static int x = Integer.signum(0);\n"
                        + "static { if (x == 0) throw new IllegalArgumentException(\"no\"); }\n"
                        + "static int x() { return x; } }\n";
        Report report = JUDGE.grade(method("out.plot(Late.x(), 0);\n") + late);
        assertEquals(0, report.points().total(), () -> report.cases().toString());
    }

    static Stream<Arguments> throwing() {
        return Stream.of(
                argumentSet(
                        "initialiser of a class that is used late throws",
                        "java.lang.ArithmeticException: / by zero; in line 8",
                        method("out.plot(Late.x(), 0);\n")
                                + "class Late { static final int X = 1 / (1 - 1);\n"
                                + "static int x() { return X; } }\n"),
                argumentSet(
                        "later cases say nothing of what the initialiser threw",
                        ("java.lang.ExceptionInInitializerError: java.lang.IllegalStateException: one: [two]; in line 9\n")
                                .repeat(2),
                        method("out.plot(Late.x(), 0);\n")
                                + "class Late { static int x = Integer.signum(0);\n"
                                + "static { if (x == 0)"
                                + " throw new IllegalStateException(\"one: [two]\"); }\n"
                                + "static int x() { return x; } }\n"),
                argumentSet(
                        "later cases say nothing of what the initialiser threw without a message",
                        ("java.lang.ExceptionInInitializerError: java.lang.IllegalStateException; in line 9\n")
                                .repeat(2),
                        method("out.plot(Late.x(), 0);\n")
                                + "class Late { static int x = Integer.signum(0);\n"
                                + "static { if (x == 0) throw new IllegalStateException(); }\n"
                                + "static int x() { return x; } }\n"),
                argumentSet(
                        "static initialiser throws",
                        "creating the object: java.lang.ExceptionInInitializerError: java.lang.ArithmeticException: / by zero; in line 4",
                        Sources.RIGHT.replace(
                                "public void", "static int z = 1 / (1 - 1);\npublic void")));
    }
}
