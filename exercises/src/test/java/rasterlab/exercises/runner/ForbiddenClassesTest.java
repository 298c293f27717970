package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.exercises.Sources.method;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Report;

/** Reads what a student is told of a class that may not be used. */
@Tag("slow")
class ForbiddenClassesTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @ParameterizedTest(name = "one mistake has several messages, or words of the compiler: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "try { new java.io.FileWriter(\"x\").close(); } catch (java.io.IOException e) { }"
                        + "| the class java.io.FileWriter is not allowed"
                        + "| класс java.io.FileWriter в этом задании не разрешён",
                "try { if (x0 > 0) throw new java.io.IOException(); }"
                        + " catch (java.io.IOException e) { }"
                        + "| the class java.io.IOException is not allowed"
                        + "| класс java.io.IOException в этом задании не разрешён",
                "Runtime.getRuntime().gc();"
                        + "| the class java.lang.Runtime is not allowed"
                        + "| класс java.lang.Runtime в этом задании не разрешён",
                "try { Class.forName(\"A\").getMethod(\"b\").invoke(null); } catch (Exception e) { }"
                        + "| java.lang.Class.forName is not allowed in this exercise;"
                        + " of java.lang.Class these are allowed: desiredAssertionStatus, getName,"
                        + " getSimpleName"
                        + "| java.lang.Class.forName в этом задании не разрешено;"
                        + " у java.lang.Class разрешено: desiredAssertionStatus, getName,"
                        + " getSimpleName",
                "new java.io.PrintStream(System.out).println();"
                        + "| the constructor of java.io.PrintStream is not allowed"
                        + "| конструктор класса java.io.PrintStream в этом задании не разрешён",
            })
    void aMistakeIsToldOnceAtItsLine(String body, String english, String russian) throws Exception {
        Report report = JUDGE.grade(method("\n" + body + "\n"));
        assertEquals(1, report.diagnostics().size(), report.diagnostics()::toString);
        Diagnostic told = report.diagnostics().get(0);
        assertEquals(6, told.line());
        assertTrue(told.message("en").startsWith(english), told.message("en"));
        assertTrue(told.message("ru").startsWith(russian), told.message("ru"));
    }

    @Test
    @DisplayName("what is allowed is said again with every class that is not")
    void whatIsAllowedIsSaidOnce() throws Exception {
        String body =
                """

                new Thread();
                System.gc();
                new java.io.File("x");
                System.exit(0);
                """;
        List<String> told =
                JUDGE.grade(method(body)).diagnostics().stream()
                        .map(one -> one.line() + " " + one.message())
                        .toList();
        assertEquals(
                List.of(
                        "6 the class java.lang.Thread is not allowed in this exercise",
                        "7 java.lang.System.gc is not allowed in this exercise",
                        "8 the class java.io.File is not allowed in this exercise; arithmetic,"
                                + " strings, arrays, collections and System.out are allowed",
                        "9 java.lang.System.exit is not allowed in this exercise; of"
                                + " java.lang.System these are allowed: "),
                told.stream()
                        .map(one -> one.replaceFirst("(System these are allowed: ).*", "$1"))
                        .toList());
    }

    @Test
    @DisplayName("what stands first in a line is told after what its lambda does not do")
    void mistakesOfALineAreToldInTheirOrder() throws Exception {
        String body = "\nRunnable r = () -> System.exit(0); new Thread(r).start();\n";
        List<Diagnostic> told = JUDGE.grade(method(body)).diagnostics();
        assertTrue(told.get(0).message().startsWith("java.lang.System.exit"), told::toString);
        assertTrue(told.get(1).message().startsWith("the class java.lang.Thread"), told::toString);
    }

    @ParameterizedTest(name = "a place behind tabs is told as a terminal shows it: {0}")
    @CsvSource({"'\t', 11", "'    ', 14", "'\t\t ', 13"})
    void placesAreCountedInCharacters(String indentation, int column) throws Exception {
        List<Diagnostic> told =
                JUDGE.grade(method("\n" + indentation + "int n = 1 \n")).diagnostics();
        assertEquals(6, told.get(0).line());
        assertEquals(column, told.get(0).column());
        assertEquals("';' expected", told.get(0).message());
    }

    @ParameterizedTest(name = "two mistakes in one line are told one after the other: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "System.exit(0); double r = Math.random();"
                        + "| java.lang.System.exit | java.lang.Math.random",
                "new Thread(() -> System.exit(0)).start();"
                        + "| the class java.lang.Thread | java.lang.System.exit",
                "Object f = new java.io.File(\"x\"), p = java.nio.file.Path.of(\"x\");"
                        + "| the class java.io.File | the class java.nio.file.Path",
            })
    void eachMistakeOfALineIsTold(String body, String one, String other) throws Exception {
        Report report = JUDGE.grade(method("\n" + body + "\n"));
        assertEquals(2, report.diagnostics().size(), report.diagnostics()::toString);
        String told = report.diagnostics().toString();
        assertTrue(told.contains(one) && told.contains(other), told);
        for (Diagnostic each : report.diagnostics()) assertEquals(6, each.line());
    }
}
