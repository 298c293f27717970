package rasterlab.exercises.predicting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** Questions come from the recorded steps of a method, and anew from each seed. */
class SheetTest {
    private static final Exercise LINE = Catalogue.builtIn().named("predict-line");

    private static Sheet sheet(long seed) {
        return Sheet.of(LINE.topic(), LINE.predicting().orElseThrow(), seed);
    }

    @Test
    void theSameSeedDrawsTheSameQuestionsAndAnotherOneOthers() {
        assertEquals(sheet(5), sheet(5));
        assertNotEquals(sheet(5).questions(), sheet(6).questions());
    }

    @Test
    void asksForAsManyStepsAsTheExerciseSays() {
        for (long seed = 0; seed < 50; seed++)
            assertEquals(16, sheet(seed).questions().size(), "seed " + seed);
    }

    @Test
    void eachQuestionHasTheRightStepsBeforeIt() {
        List<Question> questions = sheet(1).questions();
        for (int i = 1; i < questions.size(); i++) {
            Question before = questions.get(i - 1);
            Question one = questions.get(i);
            if (one.before().size() == 1) continue;
            assertEquals(before.input(), one.input());
            assertEquals(before.step(), one.before().get(one.before().size() - 1));
        }
    }

    @Test
    void theFirstPixelIsShownWithTheValueThatDecidesOnTheNext() {
        Question first = sheet(1).questions().get(0);
        assertEquals(1, first.before().size());
        assertEquals(first.before().get(0).path("decision"), first.reason().orElseThrow());
    }

    @Test
    void noAnswerStandsInTheSheet() {
        String text = SheetText.open(LINE, 7);
        String answers = text.substring(text.indexOf("\"answers\""));
        assertEquals(32, answers.split("null", -1).length - 1, answers);
        String questions = text.substring(0, text.indexOf("\"answers\""));
        int rounds = questions.split("\"input\"", -1).length - 1;
        assertEquals(rounds, questions.split("\"decision\"", -1).length - 1, questions);
        assertTrue(text.contains("\"seed\": 7,"), text);
        assertFalse(text.contains(".0"), text);
    }
}
