package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** An input has to have one answer, whatever was drawn before it. */
@Tag("slow")
class RepeatedTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    private static Report withState(String before) throws InterruptedException {
        return JUDGE.grade(
                Sources.RIGHT
                        .replace("public void", "static int calls;\npublic void")
                        .replace("long dx", before + "\nlong dx"));
    }

    @Test
    @DisplayName("a line that depends on how many came before is right")
    void anAnswerThatDependsOnTheOrderIsWrong() throws Exception {
        Report report = withState("if (++calls > 9) x1++;");
        assertEquals(GradingVerdict.WRONG, report.verdict());
        String first = report.diagnostics().get(0).message();
        assertTrue(first.startsWith("not repeatable: the same input gave another answer"), first);
        assertTrue(first.contains("for example on the line from ("), first);
    }

    @Test
    @DisplayName("a method that remembers without harm is wrong")
    void aCounterAloneIsNoFault() throws Exception {
        assertEquals(GradingVerdict.OK, withState("calls++;").verdict());
    }
}
