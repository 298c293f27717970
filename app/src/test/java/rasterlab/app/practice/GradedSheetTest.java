package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.HandedAnswers;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.SheetText;

/** A sheet that is answered in a lab and handed in. */
class GradedSheetTest {
    private final List<String> kept = new ArrayList<>();
    private final List<String> handedIn = new ArrayList<>();
    private final List<String> backTo = new ArrayList<>();
    private final PracticeModel model =
            new PracticeModel(
                    new PracticeExercises(),
                    () -> 7,
                    Runnable::run,
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void endThread() {
        model.close();
    }

    private Exercise begin(String id, String sheet) {
        Exercise exercise = Catalogue.builtIn().named(id);
        model.answer(
                new GradedSheet(
                        exercise,
                        HandedAnswers.of(exercise, sheet),
                        kept::add,
                        handedIn::add,
                        () -> backTo.add(id)));
        return exercise;
    }

    private Exercise begin(String id) {
        return begin(id, SheetText.open(Catalogue.builtIn().named(id), 5));
    }

    private Question question() {
        return model.state().question();
    }

    private ObjectNode wrong() {
        ObjectNode answer = question().right();
        return answer.put("x", answer.get("x").intValue() + 2);
    }

    @Test
    void aWrongAnswerIsToldAndTheWalkGoesOnFromTheRightStep() {
        begin("predict-line");
        Question asked = question();
        ObjectNode wrong = wrong();
        model.answer(wrong, 0);
        List<JsonNode> steps = model.state().steps();
        assertEquals(asked.step(), steps.get(steps.size() - 1));
        assertFalse(model.state().last().orElseThrow().right());
        assertEquals(Optional.of(wrong), model.state().wrong());
        assertEquals(0, model.state().given(), "it is not practice");
    }

    @Test
    void anAnswerStaysOnceItIsJudged() {
        begin("predict-line");
        ObjectNode wrong = wrong();
        model.answer(wrong, 0);
        model.turn(-1);
        model.answer(question().right(), 0);
        assertEquals(1, kept.size());
        assertEquals(wrong, model.state().last().orElseThrow().answer());
    }

    @Test
    void aLaterQuestionWhichTellsWhatIsRightWaitsForItsTurn() {
        begin("predict-line");
        model.turn(3);
        assertEquals(0, model.state().at());
        model.answer(question().right(), 0);
        model.turn(3);
        assertEquals(1, model.state().at());
    }

    @Test
    void whatIsAnsweredStandsInTheSheet() {
        Exercise exercise = begin("predict-line");
        ObjectNode wrong = wrong();
        model.answer(wrong, 0);
        ObjectNode right = question().right();
        model.answer(right, 0);
        HandedAnswers handed = HandedAnswers.of(exercise, kept.get(1));
        assertEquals(5, handed.sheet().seed());
        assertEquals(wrong.get("x"), handed.answers().get(0).get("x"));
        assertTrue(handed.sheet().questions().get(1).isRight(handed.answers().get(1)));
        assertTrue(handed.sheet().questions().get(2).isOpen(handed.answers().get(2)));
    }

    @Test
    void aSheetGoesOnAtItsFirstOpenQuestion() {
        begin("predict-line");
        model.answer(question().right(), 0);
        model.answer(question().right(), 0);
        String sheet = kept.get(1);
        model.leave();
        assertEquals(List.of("predict-line"), backTo);
        begin("predict-line", sheet);
        assertEquals(2, model.state().at());
        model.turn(-1);
        assertEquals(
                question().right().get("x").intValue(),
                model.state().last().orElseThrow().answer().get("x").intValue());
        model.turn(-5);
        assertEquals(0, model.state().at());
    }

    @Test
    void aSheetThatGivesWayToTheLabKeepsItsAnswersAndCallsNoExercise() {
        begin("predict-line");
        model.answer(question().right(), 0);
        model.giveWay();
        assertEquals(PracticeState.LEFT, model.state());
        assertEquals(List.of(), backTo);
        assertEquals(List.of(), handedIn);
        begin("predict-line", kept.get(0));
        assertEquals(1, model.state().at());
    }

    @Test
    void theLastAnswerHandsNothingInByItself() {
        begin("predict-line");
        int size = model.state().asked().orElseThrow().size();
        for (int i = 0; i < size; i++) {
            model.answer(question().right(), 0);
            model.next();
        }
        assertEquals(List.of(), handedIn);
        assertEquals(size - 1, model.state().at());
        model.handIn();
        assertEquals(List.of(kept.get(size - 1)), handedIn);
        assertEquals(PracticeState.LEFT, model.state());
    }

    @Test
    void newDataAreNotDrawnForASheet() {
        begin("predict-line");
        String input = question().input();
        model.newData();
        assertEquals(input, question().input());
        assertTrue(model.state().graded().isPresent());
    }

    static List<String> exercises() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == TaskKind.PREDICT)
                .map(Exercise::id)
                .toList();
    }

    @ParameterizedTest(name = "{0}: its sheet cannot be answered to the end")
    @MethodSource("exercises")
    void everySheetIsDrawnToItsEnd(String id) {
        Exercise exercise = begin(id);
        int size = model.state().asked().orElseThrow().size();
        for (int i = 0; i < size; i++) {
            PracticeState state = model.state();
            Sketches.of(exercise.topic())
                    .ifPresent(
                            sketch ->
                                    assertFalse(
                                            sketch.of(
                                                            new Sketch.Walked(
                                                                    WalkText.input(
                                                                            question().input()),
                                                                    state.steps(),
                                                                    state.givenFields(),
                                                                    state.wrong()))
                                                    .figures()
                                                    .isEmpty()));
            model.answer(question().right(), 0);
            model.next();
        }
        HandedAnswers handed = HandedAnswers.of(exercise, kept.get(size - 1));
        for (int i = 0; i < size; i++)
            assertTrue(
                    handed.sheet().questions().get(i).isRight(handed.answers().get(i)),
                    "question " + (i + 1));
    }
}
