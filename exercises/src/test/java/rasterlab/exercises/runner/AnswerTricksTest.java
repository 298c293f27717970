package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** Programs that are right only where they are looked at earn what that is worth. */
@Tag("slow")
class AnswerTricksTest {
    private static final String HEAD =
            "public void draw(int x0, int y0, int x1, int y1, Pixels out) {";

    private static final String SHADE = "public double[] shade(LitFace face, double[] weights) {";
    private static final String FIELD = "\nprivate static double[] kept;\n";

    @RegisterExtension
    static final StartedJudge JUDGE =
            new StartedJudge(JudgeSettings.once().withSpeed(JudgeSettings.Speed.OFF));

    @Test
    @DisplayName("answers to the open cases alone earn all points")
    void answersToOpenCasesAreNotEnough() throws Exception {
        Exercise exercise = Catalogue.builtIn().named("line-bresenham");
        String known =
                exercise.cases().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .map(one -> '"' + one.input().replaceAll("[^-0-9,]", "") + '"')
                        .collect(Collectors.joining(", ", "java.util.Set.of(", ")"));
        String source =
                Sources.RIGHT.replace(
                        HEAD,
                        HEAD
                                + "\nif (!"
                                + known
                                + ".contains(x0 + \",\" + y0 + \",\" + x1 + \",\" + y1)) return;\n");
        Report report = JUDGE.grade(exercise, source, CaseSelection.all(5));
        long passed =
                report.cases().stream().filter(one -> one.verdict() == GradingVerdict.OK).count();
        assertTrue(passed >= 3, () -> passed + " cases: the trick does not even work");
        assertEquals(GradingVerdict.WRONG, report.verdict());
        assertTrue(2 * report.points().total() < 100, () -> report.points().toString());
    }

    @Test
    @DisplayName("a line that is drawn by chance passes where luck helps")
    void chanceIsNotRepeatable() throws Exception {
        Report report =
                JUDGE.grade(
                        Sources.RIGHT.replace(
                                "long dx",
                                "if ((new Object().hashCode() & 7) < 2) x1++;\nlong dx"));
        assertEquals(GradingVerdict.WRONG, report.verdict());
        String said = report.diagnostics().toString();
        assertTrue(said.contains("not repeatable"), said);
    }

    @Test
    @DisplayName("an input that was kept is the next call's too")
    void aKeptInputIsNotTheNextOne() throws Exception {
        Report report =
                shadedWith(
                        SHADE
                                + "\nif (kept != null) { if (kept == weights) return null;"
                                + " java.util.Arrays.fill(kept, 7); }\nkept = weights;\n");
        assertEquals(GradingVerdict.OK, report.verdict(), () -> messages(report));
    }

    @Test
    @DisplayName("an array that is changed after it was returned counts as it is then")
    void anAnswerThatIsChangedLaterCountsAsItWas() throws Exception {
        Report report =
                shadedWith(
                        SHADE
                                + "\nif (kept != null) java.util.Arrays.fill(kept, 7);\n"
                                + "return kept = answer(face, weights);\n}\n"
                                + "private static double[] answer(LitFace face, double[] weights) {");
        assertEquals(GradingVerdict.OK, report.verdict(), () -> messages(report));
    }

    /** The result of the right shading whose method begins otherwise, and keeps an array. */
    private static Report shadedWith(String beginning) throws Exception {
        Exercise shading = Catalogue.builtIn().named("shade-face");
        String model = shading.evidence().model().orElseThrow();
        assertTrue(model.contains(SHADE), model);
        String source =
                model.replace(SHADE, beginning)
                        .replace("implements FaceShader {", "implements FaceShader {" + FIELD);
        return JUDGE.grade(shading, source, CaseSelection.open());
    }

    @Test
    @DisplayName("minus zero is wrong where zero is right")
    void minusZeroCountsAsZero() throws Exception {
        Exercise color = Catalogue.builtIn().named("color");
        String model = color.evidence().model().orElseThrow();
        String right = "return fromRgb(to, toRgb(from, components));";
        assertTrue(model.contains(right), model);
        String source =
                model.replace(
                        right,
                        """
                        double[] answer = fromRgb(to, toRgb(from, components));
                        for (int i = 0; i < answer.length; i++)
                            if (answer[i] == 0) {
                                System.out.print("zero ");
                                answer[i] = -0.0;
                            }
                        return answer;
                        """);
        Report report = JUDGE.grade(color, source, CaseSelection.open());
        assertEquals(GradingVerdict.OK, report.verdict(), () -> messages(report));
        assertTrue(messages(report).contains("zero "), "no case has a zero");
    }

    private static String messages(Report report) {
        return report.cases().stream().map(CaseReport::message).collect(Collectors.joining("\n"))
                + report.diagnostics();
    }
}
