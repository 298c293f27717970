package rasterlab.exercises.marking;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;

/**
 * One call of a case and what came of it.
 *
 * @param answer nothing where the method was stopped
 * @param finding verdict and causes
 */
public record TriedCall(GradedCall call, Optional<Answer> answer, Finding finding) {
    /** The worth of an answer by itself. */
    public static TriedCall answered(GradedCall call, Answer answer) {
        return new TriedCall(call, Optional.of(answer), call.check(answer));
    }

    /** The method was stopped, or gave another answer the second time. */
    public static TriedCall failed(GradedCall call, Finding finding) {
        return new TriedCall(call, Optional.empty(), finding);
    }

    /** The call on the input whose answer is not right, where several were asked for. */
    GradedCall inQuestion() {
        return answer.map(call::inQuestion).orElse(call);
    }

    boolean right() {
        return finding.right();
    }

    /** Whether it is right because a refusal is as good as an answer here. */
    boolean refused() {
        return right() && answer.filter(one -> one.ending() == Answer.CallEnding.THREW).isPresent();
    }

    /** Whether the other is the same answer to the same input. */
    public boolean isRepeatedBy(TriedCall other) {
        return answer.isPresent()
                && other.answer.isPresent()
                && answer.get().isSameAs(other.answer.get());
    }

    /** Where it is wrong, what may explain all of it: each some codes of mistakes. */
    List<List<String>> explanations() {
        return finding.verdict() == GradingVerdict.WRONG
                ? finding.explanations().stream().map(Cause::codes).distinct().toList()
                : List.of();
    }

    /** Whether the wrong answer comes by that slip. */
    boolean comesBySlip(String slip) {
        return answer.filter(one -> call.comesBySlip(slip, one)).isPresent();
    }

    /** Whether the answer, right or wrong, fits a program that changes every right one so. */
    boolean fits(String change) {
        if (right()) return call.isRightWith(change);
        return answer.map(one -> call.comesBy(change, one)).orElse(true);
    }

    boolean mayBe(Set<String> mistakes) {
        return explanations().stream().flatMap(List::stream).anyMatch(mistakes::contains);
    }

    /**
     * Whether the call counts in any case: it was stopped, or answered otherwise the second time.
     */
    boolean alwaysCounts() {
        return !right() && answer.isEmpty();
    }

    /** A line of nothing is no line with a mistake, even where one pixel is all that it lacks. */
    boolean drewSomething() {
        return answer.filter(one -> one.items() > 0).isPresent();
    }

    /**
     * A single point is its own first and last pixel, and of a cut line the last end is not seen:
     * what is wrong or right there tells no mistake. Nor does it where it is not known on which of
     * several inputs.
     */
    boolean tellsLittle() {
        Set<String> traits = inQuestion().traits();
        return traits.contains("point")
                || traits.contains("cut")
                || traits.contains(TopicGrading.SEVERAL);
    }

    /** The input as a scene file, with the answer where it is wrong. */
    String scene() {
        return call.scene(answer.filter(one -> !right()));
    }

    /** The mistake of a method that does nothing, where the answer may be one of such. */
    Optional<Cause> idle() {
        return answer.flatMap(call::idle);
    }

    /** Whether an output came: no exception, no end from outside. */
    boolean answered() {
        return answer.flatMap(Answer::output).isPresent();
    }

    /** The finding with pictures on an answer of a program that does nothing. */
    Finding shown(Cause idle) {
        return answer.filter(one -> one.output().isPresent())
                .map(one -> call.judgeIdle(one, idle))
                .orElseGet(this::shown);
    }

    /** The finding with pictures. */
    public Finding shown() {
        return answer.map(call::judge).orElse(finding);
    }
}
