package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import rasterlab.exercises.predicting.Question;

/**
 * The answers so far to a sheet that is handed in. Nothing that is right shows in it.
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

    /** The steps that the sheet shows, and those before a question as they were answered. */
    List<JsonNode> steps(PracticeSheet sheet, int at) {
        Question now = sheet.question(at);
        var steps = new ArrayList<>(now.before().subList(0, now.rules().shown()));
        for (int i = 0; i < at; i++) {
            Question one = sheet.question(i);
            if (!one.input().equals(now.input()) || !has(sheet, i)) continue;
            ObjectNode step = one.told();
            one.rules().asked().forEach(each -> step.set(each.field(), answer(one, each.field())));
            steps.add(step);
        }
        return steps;
    }

    private JsonNode answer(Question one, String field) {
        return answers.get(one.number() - 1).path(field);
    }
}
