package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** The report's line on speed says what was measured, or why nothing was. */
@Tag("slow")
class SpeedTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @Test
    void aPrintForEachLineDoesNotEndTheMeasurement() throws Exception {
        Report report = report(drawing("System.out.println(\"from \" + x0 + \", \" + y0);"));
        assertEquals(GradingVerdict.OK, speed(report).verdict(), speed(report)::message);
        assertTrue(report.nanosPerItem() > 0, speed(report)::message);
    }

    @Test
    void muchPrintingIsNamedAsTheCauseOfALoss() throws Exception {
        String much = "for (int i = 0; n == 1001 && i < 2000; i++) System.out.print(x0);";
        CaseReport speed = speed(report(drawing(much)));
        assertEquals(0, speed.points());
        assertTrue(speed.message().contains("printing is part of that time"), speed::message);
    }

    @Test
    void anExceptionOnTheLongLinesIsNamed() throws Exception {
        CaseReport speed =
                speed(report(drawing("if (n == 1001) throw new IllegalStateException();")));
        assertEquals(GradingVerdict.NOT_MEASURED, speed.verdict());
        assertEquals("it threw java.lang.IllegalStateException on the long lines", speed.message());
    }

    /** The exception's name could tell on which line it was thrown. */
    @Test
    void anExceptionOfTheStudentsOwnIsNotNamedOnTheLongLines() throws Exception {
        String own = "static class Line1001 extends RuntimeException { }\npublic void";
        String source = drawing("if (n == 1001) throw new Line1001();").replace("public void", own);
        CaseReport speed = speed(report(source));
        assertEquals("it threw an exception of its own on the long lines", speed.message());
    }

    /** The method loses the points of the cases on the last pixel and keeps those for speed. */
    @Test
    void aMistakeThatWasPaidForIsTimed() throws Exception {
        CaseReport speed = speed(report(Sources.RIGHT.replace("k <= n", "k < n")));
        assertEquals(10, speed.points(), speed::message);
    }

    @Test
    void nothingTellsWhetherAMethodIsTimed() throws Exception {
        String telling =
                "String sheet = out.getClass().getName();\n"
                        + "if (!sheet.equals(\"rasterlab.exercises.child.WholeSheets$OfPixels\") || out == last) x++;\n"
                        + "last = out;";
        String source = drawing(telling).replace("public void", "static Pixels last;\npublic void");
        Report report = report(source);
        assertEquals(GradingVerdict.OK, report.verdict());
        assertEquals(GradingVerdict.OK, speed(report).verdict(), speed(report)::message);
    }

    /**
     * A method that keeps its answers gains nothing by it: it draws wrong where an input returns.
     */
    @Test
    void noInputIsTimedTwice() throws Exception {
        String keeping = "if (n == 1001 && !seen.add(java.util.List.of(x0, y0, x1, y1))) x++;";
        String field =
                "static java.util.Set<java.util.List<Integer>> seen = new java.util.HashSet<>();";
        String source = drawing(keeping).replace("public void", field + "\npublic void");
        CaseReport speed = speed(report(source));
        assertEquals(GradingVerdict.OK, speed.verdict(), speed::message);
    }

    @Test
    void wrongPixelsOnTheLongLinesAreNamed() throws Exception {
        CaseReport speed = speed(report(drawing("if (n == 1001) x++;")));
        assertEquals(GradingVerdict.NOT_MEASURED, speed.verdict());
        assertEquals("pixels are wrong on the long lines", speed.message());
    }

    /** The exception that ends it then is our own, and no name for a student to read. */
    @Test
    void plottingWithoutEndOnTheLongLinesIsWrong() throws Exception {
        CaseReport speed = speed(report(drawing("while (n == 1001) out.plot(x, y);")));
        assertEquals("pixels are wrong on the long lines", speed.message());
    }

    @Test
    void anInaccurateMethodIsNotCalledRight() throws Exception {
        CaseReport speed = speed(report(Sources.NAIVE_TEXTBOOK));
        assertEquals(GradingVerdict.NOT_MEASURED, speed.verdict());
        assertEquals(
                "speed is measured once you have 80 % of the accuracy points", speed.message());
    }

    /** The right solution with a statement before its loop. */
    private static String drawing(String statement) {
        return Sources.RIGHT.replace("for (long k", statement + "\nfor (long k");
    }

    private static Report report(String source) throws InterruptedException {
        return JUDGE.grade(source);
    }

    private static CaseReport speed(Report report) {
        return report.cases().stream()
                .filter(one -> one.name().equals("speed"))
                .findFirst()
                .orElseThrow();
    }
}
