package rasterlab.exercises.predicting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** Each step is compared with the method's, and paid for alone. */
class SheetGradingTest {
    private static final Exercise LINE = Catalogue.builtIn().named("predict-line");
    private static final Exercise CURVE = Catalogue.builtIn().named("predict-curve");
    private static final long SEED = 11;

    private static Sheet sheet(Exercise exercise) {
        return Sheet.of(exercise.topic(), exercise.predicting().orElseThrow(), SEED);
    }

    private static Report report(
            Exercise exercise, CaseSelection cases, Function<Question, JsonNode> answer) {
        String sent = SheetText.written(exercise.id(), sheet(exercise), answer);
        return new SheetGrading(exercise, cases, done -> {}).report(sent);
    }

    private static JsonNode moved(Question one, String field, double by) {
        ObjectNode answer = one.right();
        return answer.put(field, answer.get(field).doubleValue() + by);
    }

    @Test
    void theMethodsOwnStepsEarnAllPoints() {
        Report report = report(LINE, CaseSelection.open(), Question::right);
        assertEquals(GradingVerdict.OK, report.verdict());
        assertEquals(100, report.points().accuracy());
    }

    @Test
    void aWrongStepLosesItsPointsAloneAndIsToldWithTheValueThatDecides() {
        Report report =
                report(
                        LINE,
                        CaseSelection.open(),
                        one -> one.number() == 3 ? moved(one, "y", 1) : one.right());
        CaseReport third = report.cases().get(2);
        assertEquals(GradingVerdict.WRONG, report.verdict());
        assertEquals(GradingVerdict.WRONG, third.verdict());
        assertEquals(100 - third.of(), report.points().accuracy());
        Question question = sheet(LINE).questions().get(2);
        String right = "x = " + question.right().get("x") + ", y = " + question.right().get("y");
        String value = question.before().get(2).path("decision").asText();
        assertTrue(third.message().contains("right is " + right), third.message());
        assertTrue(third.message().endsWith("here it is " + value), third.message());
        assertTrue(
                third.message("ru").endsWith("здесь " + value.replace('-', '−')),
                third.message("ru"));
    }

    @Test
    void aHalfAnsweredStepIsNotAnswered() {
        ObjectNode half = JsonNodeFactory.instance.objectNode();
        Report report =
                report(
                        LINE,
                        CaseSelection.open(),
                        one -> half.deepCopy().set("x", one.right().get("x")));
        assertEquals(0, report.points().accuracy());
        assertTrue(report.cases().get(0).message().startsWith("not answered; right is x = "));
    }

    @Test
    void aNumberMayBeOffByTheToleranceAndNoMore() {
        double within = 0.019;
        double beyond = 0.021;
        assertEquals(
                100,
                report(CURVE, CaseSelection.open(), one -> moved(one, "x", within))
                        .points()
                        .accuracy());
        assertEquals(
                0,
                report(CURVE, CaseSelection.open(), one -> moved(one, "x", -beyond))
                        .points()
                        .accuracy());
    }

    @Test
    void theSheetOfAnotherSeedIsRefusedWhereTheSeedIsSet() {
        Report report = report(LINE, CaseSelection.all(SEED + 1), Question::right);
        assertEquals(GradingVerdict.REFUSED, report.verdict());
        assertEquals(0, report.points().total());
        String said = report.diagnostics().get(0).message("en");
        assertTrue(said.contains("its seed is 11, and this attempt's is 12"), said);
        assertEquals(100, report(LINE, CaseSelection.all(SEED), Question::right).points().total());
    }

    @Test
    void changedQuestionsChangeNothing() {
        String sent =
                SheetText.written(LINE.id(), sheet(LINE), Question::right)
                        .replaceFirst("\"questions\": \\[", "\"questions\": [7, ");
        Report report = new SheetGrading(LINE, CaseSelection.open(), done -> {}).report(sent);
        assertEquals(100, report.points().accuracy());
    }

    @Test
    void eachStepIsToldAsItIsJudgedAndOpensInTheLab() {
        List<String> told = new ArrayList<>();
        String sent = SheetText.open(LINE, SEED);
        new SheetGrading(LINE, CaseSelection.open(), one -> told.add(one.scene())).report(sent);
        assertEquals(16, told.size());
        MethodCase scene = (MethodCase) SceneFile.read(told.get(0));
        assertEquals("line", scene.topic());
        assertEquals("midpoint", scene.method().orElseThrow());
    }
}
