package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.exercises.Sources.method;

import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Report;

/** What a student reads of a class that may not be used. */
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
