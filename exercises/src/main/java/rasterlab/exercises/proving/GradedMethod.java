package rasterlab.exercises.proving;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.study.InputChanged;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.marking.CaseTrial;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;

/** Tries a method of this program on all cases, in this process, and keeps what came of them. */
public final class GradedMethod {
    private static final String REFUSAL = IllegalArgumentException.class.getName();

    private final Exercise exercise;

    /** All that came of the cases, and what they pay. */
    final Marking marking;

    private GradedMethod(Exercise exercise, Marking marking) {
        this.exercise = exercise;
        this.marking = marking;
    }

    /**
     * The calls of each of the exercise's cases, on which many methods may be tried: what is right
     * there is worked out once for all of them.
     */
    static Map<Case, List<TopicGrading.GradedCall>> calls(
            Exercise exercise, TopicGrading grading, long seed) {
        return calls(exercise, exercise.cases(), grading, seed);
    }

    static Map<Case, List<TopicGrading.GradedCall>> calls(
            Exercise exercise, List<Case> cases, TopicGrading grading, long seed) {
        Map<Case, List<TopicGrading.GradedCall>> calls = new LinkedHashMap<>();
        for (Case one : cases) calls.put(one, grading.calls(one, exercise.tolerance(), seed));
        return calls;
    }

    /** Tries a method on calls of the exercise's cases. */
    static GradedMethod on(
            Exercise exercise, Map<Case, List<TopicGrading.GradedCall>> cases, Object method) {
        Marking marking = new Marking(exercise);
        cases.forEach(
                (one, calls) -> {
                    List<TriedCall> tried = new ArrayList<>();
                    for (TopicGrading.GradedCall call : calls)
                        tried.add(TriedCall.answered(call, answer(call, method)));
                    marking.put(CaseTrial.tried(one, tried));
                });
        return new GradedMethod(exercise, marking);
    }

    /** The answer of a method of this program, or how it ends. */
    public static Answer answer(TopicGrading.GradedCall call, Object method) {
        try {
            return Answer.with(
                    Answer.CallEnding.RETURNED,
                    call.recorded(method, call.caps().items()),
                    1,
                    "",
                    "");
        } catch (LimitReached reached) {
            return Answer.with(Answer.CallEnding.CUT, reached.recorded(), 1, "", "");
        } catch (InputChanged changed) {
            return Answer.without(Answer.CallEnding.OVERWROTE, "", "", "");
        } catch (RuntimeException | StackOverflowError thrown) {
            return Answer.threw(thrown.getClass().getName(), "" + thrown.getMessage(), 0, "");
        }
    }

    /** Names of the cases that pay nothing. */
    List<String> failed() {
        List<String> paying = marking.paying();
        return exercise.cases().stream()
                .map(Case::name)
                .filter(name -> !paying.contains(name))
                .toList();
    }

    int points(Criterion kind) {
        List<String> paying = marking.paying();
        return exercise.cases().stream()
                .filter(one -> one.kind() == kind && paying.contains(one.name()))
                .mapToInt(Case::points)
                .sum();
    }

    /**
     * Names of the cases in which a wrong answer is told to be a mistake.
     *
     * @param codes by which the mistake may be told
     */
    List<String> naming(Set<String> codes) {
        return marking.cases().stream()
                .filter(one -> findings(one).anyMatch(finding -> isNamed(finding, codes)))
                .map(one -> one.one().name())
                .toList();
    }

    /**
     * Names of the cases whose property is broken, be the answers right to the tolerance or not.
     */
    public List<String> breaking() {
        return marking.cases().stream()
                .filter(one -> one.calls().stream().anyMatch(GradedMethod::isBroken))
                .map(one -> one.one().name())
                .toList();
    }

    private static boolean isBroken(TriedCall tried) {
        return tried.answer().filter(tried.call()::breaksProperty).isPresent();
    }

    private static boolean isNamed(Finding finding, Set<String> codes) {
        return finding.explanations().stream()
                .flatMap(causes -> Cause.codes(causes).stream())
                .anyMatch(codes::contains);
    }

    /** Whether it gave a wrong answer, so that its mistake could be told by that. */
    boolean answeredWrong() {
        return marking.cases().stream()
                .flatMap(GradedMethod::findings)
                .anyMatch(finding -> finding.verdict() == GradingVerdict.WRONG);
    }

    /** Names of the cases in which all that is not right is a refusal. */
    List<String> refused() {
        List<String> failed = failed();
        return marking.cases().stream()
                .filter(
                        one ->
                                one.calls().stream()
                                        .filter(call -> !call.finding().right())
                                        .allMatch(GradedMethod::isRefused))
                .map(one -> one.one().name())
                .filter(failed::contains)
                .toList();
    }

    private static boolean isRefused(TriedCall call) {
        return call.answer()
                .filter(one -> one.ending() == Answer.CallEnding.THREW)
                .filter(one -> one.exception().equals(REFUSAL))
                .isPresent();
    }

    private static Stream<Finding> findings(CaseTrial tried) {
        return tried.calls().stream().map(TriedCall::finding).filter(one -> !one.right());
    }
}
