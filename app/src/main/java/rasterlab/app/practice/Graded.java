package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.predicting.Question;

/**
 * The answers so far to a sheet that is handed in.
 *
 * @param answers one for each question; a missing node, or one with nulls, where none is given
 */
record Graded(List<JsonNode> answers) {
    Graded {
        answers = List.copyOf(answers);
    }

    Graded with(int at, JsonNode answer) {
        var changed = new ArrayList<>(answers);
        changed.set(at, answer);
        return new Graded(changed);
    }

    /** How many of the questions have an answer. */
    int given(PracticeSheet sheet) {
        int given = 0;
        for (int i = 0; i < sheet.size(); i++) if (has(sheet, i)) given++;
        return given;
    }

    boolean has(PracticeSheet sheet, int at) {
        return !sheet.question(at).isOpen(answers.get(at));
    }

    /** The first question without an answer; the last one if none is. */
    int firstOpen(PracticeSheet sheet) {
        int at = 0;
        while (at < sheet.size() - 1 && has(sheet, at)) at++;
        return at;
    }

    /** The answer to a question, judged; empty where it has none. */
    Optional<AnsweredQuestion> judged(PracticeSheet sheet, int at) {
        if (!has(sheet, at)) return Optional.empty();
        Question question = sheet.question(at);
        JsonNode answer = answers.get(at);
        return Optional.of(new AnsweredQuestion(question, answer, question.isRight(answer)));
    }
}
