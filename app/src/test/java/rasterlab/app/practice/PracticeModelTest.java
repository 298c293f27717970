package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;

class PracticeModelTest {
    private final ConcurrentLinkedQueue<Runnable> events = new ConcurrentLinkedQueue<>();
    private final ConcurrentLinkedQueue<Throwable> failures = new ConcurrentLinkedQueue<>();
    private long seeds = 7;
    private final PracticeModel model =
            new PracticeModel(new PracticeExercises(), () -> seeds++, events::add, failures::add);

    @AfterEach
    void endThread() {
        model.close();
        assertTrue(failures.isEmpty(), failures::toString);
    }

    private void settle() throws InterruptedException {
        model.settle();
        for (Runnable event = events.poll(); event != null; event = events.poll()) event.run();
    }

    private void enter(String topic) throws InterruptedException {
        model.enter(topic);
        settle();
    }

    private Question question() {
        return model.state().question();
    }

    /** Two pixels on, so that it is neither of those that may come next. */
    private ObjectNode wrong() {
        ObjectNode answer = question().right();
        return answer.put("x", answer.get("x").intValue() + 2);
    }

    @Test
    void asksWhatTheExerciseAsksOfThatSeed() throws InterruptedException {
        enter("line");
        Exercise exercise = Catalogue.builtIn().named("predict-line");
        Sheet graded = Sheet.of("line", exercise.predicting().orElseThrow(), 7);
        assertEquals(graded, model.state().asked().orElseThrow().sheet());
    }

    @Test
    void goesOnFromTheRightStepAfterAWrongAnswer() throws InterruptedException {
        enter("line");
        var first = question();
        model.answer(wrong(), 0);
        assertEquals(first.step(), question().before().get(1), "the walk has the right pixel");
        assertFalse(model.state().last().orElseThrow().right());
        assertEquals(0, model.state().right());
        model.answer(question().right(), 0);
        assertEquals(1, model.state().right());
        assertEquals(2, model.state().given());
    }

    @Test
    void showsAWrongAnswerUntilTheNextIsGiven() throws InterruptedException {
        enter("line");
        ObjectNode wrong = wrong();
        model.answer(wrong, 0);
        assertEquals(Optional.of(wrong), model.state().wrong());
        model.answer(question().right(), 0);
        assertEquals(Optional.empty(), model.state().wrong());
    }

    @Test
    void restsAtTheEndOfAWalkWithItsLastStepInSight() throws InterruptedException {
        enter("line");
        while (!model.state().resting()) model.answer(question().right(), 0);
        var last = question();
        assertEquals(last.step(), model.state().steps().get(last.before().size()));
        model.answer(last.right(), 0);
        assertEquals(last.number(), model.state().given(), "no answer counts twice");
        model.next();
        assertNotEquals(last.input(), question().input());
        assertEquals(last.number() + 1, question().number());
    }

    @Test
    void neverEndsAndKeepsTheScore() throws InterruptedException {
        enter("line");
        int size = model.state().asked().orElseThrow().size();
        Deque<Long> seen = new ArrayDeque<>();
        for (int i = 0; i < 2 * size + 1; i++) {
            if (model.state().resting()) {
                model.next();
                settle();
            }
            seen.add(model.state().seed());
            model.answer(question().right(), 0);
        }
        assertEquals(2 * size + 1, model.state().right());
        assertEquals(2 * size + 1, model.state().given());
        assertEquals(7, seen.getFirst());
        assertEquals(9, seen.getLast());
    }

    @Test
    void newDataHaveAnotherSeedAndOthersData() throws InterruptedException {
        enter("line");
        String before = question().input();
        model.newData();
        assertTrue(model.state().asked().isEmpty(), "nothing is asked while they are drawn");
        settle();
        assertEquals(8, model.state().seed());
        assertNotEquals(before, question().input());
    }

    @Test
    void aSeedThatIsTypedGivesItsDataAgain() throws InterruptedException {
        enter("line");
        var sheet = model.state().asked();
        model.newData();
        settle();
        model.dataOf(7);
        settle();
        assertEquals(sheet, model.state().asked());
    }

    @Test
    void dataThatComeAfterTheModeIsLeftAreDropped() throws InterruptedException {
        model.enter("line");
        model.leave();
        settle();
        assertEquals(PracticeState.LEFT, model.state());
    }

    @Test
    void aClickInAPlaneMayBeALittleOff() throws InterruptedException {
        enter("curve");
        ObjectNode near = question().right();
        near.put("x", near.get("x").doubleValue() + 0.1);
        model.answer(near, 0.15);
        assertTrue(model.state().last().orElseThrow().right());
        near = question().right();
        near.put("x", near.get("x").doubleValue() + 0.1);
        model.answer(near, 0);
        assertFalse(model.state().last().orElseThrow().right(), "numbers are typed exactly");
    }
}
