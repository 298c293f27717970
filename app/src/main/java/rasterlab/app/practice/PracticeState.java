package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.predicting.Question;

/**
 * What the mode shows.
 *
 * @param topic that is practised; empty while the lab is seen
 * @param seed of the questions
 * @param asked the questions; empty while they are drawn
 * @param at the present one, from 0
 * @param resting whether the walk of the present one has ended with its answer, which is still seen
 * @param last the answer given last to these questions
 * @param right answers that were right since the mode was entered
 * @param given answers since then
 */
record PracticeState(
        Optional<String> topic,
        long seed,
        Optional<PracticeSheet> asked,
        int at,
        boolean resting,
        Optional<Answered> last,
        int right,
        int given) {
    static final PracticeState LEFT =
            new PracticeState(
                    Optional.empty(), 0, Optional.empty(), 0, false, Optional.empty(), 0, 0);

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

    /** What the question tells of the step; nothing where the walk rests. */
    JsonNode told() {
        return resting ? JsonNodeFactory.instance.objectNode() : question().told();
    }

    /** The wrong answer that was given last, if it was about the newest step that is seen. */
    Optional<JsonNode> wrong() {
        return last.filter(one -> !one.right())
                .filter(one -> one.question().before().size() == steps().size() - 1)
                .map(Answered::answer);
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
                given);
    }

    PracticeState drawn(PracticeSheet sheet) {
        return new PracticeState(
                topic, seed, Optional.of(sheet), 0, false, Optional.empty(), right, given);
    }

    /** Goes on in the same walk at once; otherwise what was answered stays until the next. */
    PracticeState answered(Answered answer) {
        boolean goesOn = asked.orElseThrow().sameWalk(at, at + 1);
        return new PracticeState(
                topic,
                seed,
                asked,
                goesOn ? at + 1 : at,
                !goesOn,
                Optional.of(answer),
                right + (answer.right() ? 1 : 0),
                given + 1);
    }

    PracticeState next() {
        return new PracticeState(topic, seed, asked, at + 1, false, Optional.empty(), right, given);
    }
}
