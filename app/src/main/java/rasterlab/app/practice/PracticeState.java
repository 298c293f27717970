package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.engine.range.Bounds;
import rasterlab.exercises.predicting.Question;

/**
 * The state that the mode shows.
 *
 * @param topic that is practised; empty while the lab is seen
 * @param seed of the questions
 * @param asked the questions; empty while they are drawn
 * @param at the present one, from 0
 * @param resting whether the present one is answered and still seen: its walk has ended, or it is
 *     one of a sheet that is looked at again
 * @param last the answer given last to these questions
 * @param right answers that were right since the mode was entered
 * @param given answers since then
 * @param graded the answers to a sheet that is handed in; empty where the steps are practised
 */
record PracticeState(
        Optional<String> topic,
        long seed,
        Optional<PracticeSheet> asked,
        int at,
        boolean resting,
        Optional<AnsweredQuestion> last,
        int right,
        int given,
        Optional<Graded> graded) {
    static final PracticeState LEFT =
            new PracticeState(
                    Optional.empty(),
                    0,
                    Optional.empty(),
                    0,
                    false,
                    Optional.empty(),
                    0,
                    0,
                    Optional.empty());

    PracticeState {
        Bounds.requireAtLeast("at", at, 0);
    }

    /** A sheet to be answered and handed in, at its first question without an answer. */
    static PracticeState of(PracticeSheet sheet, Graded answers) {
        int at = answers.firstOpen(sheet);
        return seen(sheet, answers, at, answers.judged(sheet, at));
    }

    /** The question that is seen: to be answered, unless the walk rests. */
    Question question() {
        return asked.orElseThrow().question(at);
    }

    /** Whether an answer is waited for. */
    boolean isAsking() {
        return asked.isPresent() && !resting;
    }

    /** Whether the last of the questions is answered. */
    boolean isThrough() {
        return resting && at == asked.orElseThrow().size() - 1;
    }

    /** The steps that are made, with the right one where the walk rests. */
    List<JsonNode> steps() {
        Question question = question();
        return resting
                ? Stream.concat(question.before().stream(), Stream.of(question.step())).toList()
                : question.before();
    }

    /** The part of the step that the question tells; null where the walk rests. */
    JsonNode givenFields() {
        return resting ? JsonNodeFactory.instance.objectNode() : question().givenFields();
    }

    /** The wrong answer that was given last, if it was about the newest step that is seen. */
    Optional<JsonNode> wrong() {
        return last.filter(one -> !one.right())
                .filter(one -> one.question().before().size() == steps().size() - 1)
                .map(AnsweredQuestion::answer);
    }

    PracticeState drawing(String topic, long seed) {
        return new PracticeState(
                Optional.of(topic),
                seed,
                Optional.empty(),
                0,
                false,
                Optional.empty(),
                right,
                given,
                Optional.empty());
    }

    PracticeState drawn(PracticeSheet sheet) {
        return new PracticeState(
                topic,
                seed,
                Optional.of(sheet),
                0,
                false,
                Optional.empty(),
                right,
                given,
                Optional.empty());
    }

    /** Goes on in the same walk at once; otherwise what was answered stays until the next. */
    PracticeState answered(AnsweredQuestion answer) {
        boolean goesOn = asked.orElseThrow().sameWalk(at, at + 1);
        return new PracticeState(
                topic,
                seed,
                asked,
                goesOn ? at + 1 : at,
                !goesOn,
                Optional.of(answer),
                right + (answer.right() ? 1 : 0),
                given + 1,
                Optional.empty());
    }

    /**
     * Takes an answer to a sheet that is handed in, which stays. As in practice, it is judged at
     * once, and the walk goes on from the right step.
     */
    PracticeState noted(JsonNode answer) {
        PracticeSheet sheet = asked.orElseThrow();
        Graded changed = graded.orElseThrow().with(at, answer);
        boolean goesOn = sheet.sameWalk(at, at + 1);
        return seen(sheet, changed, goesOn ? at + 1 : at, changed.judged(sheet, at));
    }

    /**
     * The state at another question of a sheet that is handed in, as far as its first one without
     * an answer: a later one would tell what is right there.
     */
    PracticeState at(int other) {
        PracticeSheet sheet = asked.orElseThrow();
        Graded answers = graded.orElseThrow();
        int next = Math.max(0, Math.min(answers.firstOpen(sheet), other));
        return seen(sheet, answers, next, answers.judged(sheet, next));
    }

    private static PracticeState seen(
            PracticeSheet sheet, Graded answers, int at, Optional<AnsweredQuestion> told) {
        return new PracticeState(
                Optional.of(sheet.exercise().topic()),
                sheet.sheet().seed(),
                Optional.of(sheet),
                at,
                answers.has(sheet, at),
                told,
                0,
                0,
                Optional.of(answers));
    }

    PracticeState next() {
        if (graded.isPresent()) return at(at + 1);
        return new PracticeState(
                topic, seed, asked, at + 1, false, Optional.empty(), right, given, graded);
    }
}
