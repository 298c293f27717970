package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.marking.CaseTrial;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Tries one method on one case after the other, and then on all inputs in another order. */
final class CaseRun {
    private final Exercise exercise;
    private final TopicGrading topic;
    private final long seed;
    private final Student student;
    private final List<Diagnostic> printed = new ArrayList<>();
    private final List<GradedCall> repeated = new ArrayList<>();

    CaseRun(Exercise exercise, TopicGrading topic, long seed, Student student) {
        this.exercise = exercise;
        this.topic = topic;
        this.seed = seed;
        this.student = student;
    }

    /** The output in open cases. */
    List<Diagnostic> printed() {
        return printed;
    }

    /**
     * @throws ChildLost when the child was killed from outside: no fault of the student's
     */
    CaseTrial tryOut(Case one) throws ChildLost, InterruptedException {
        List<TriedCall> tried = new ArrayList<>();
        Shrinking shrinking = new Shrinking(student);
        for (GradedCall call : topic.calls(one, exercise.tolerance(), seed)) {
            Optional<Finding> over = student.over();
            if (over.isPresent()) return CaseTrial.untried(one, over.get());
            TriedCall next = student.call(call);
            tried.add(shrinking.of(next));
            if (next.answer().isEmpty()) break;
            keep(one, next.answer().get());
        }
        return CaseTrial.tried(one, tried);
    }

    private void keep(Case one, Answer answer) {
        if (one.visibility() != Disclosure.OPEN || answer.printed().isBlank()) return;
        Message said =
                Message.of(
                        "printed.case",
                        one.title("en"),
                        one.title("ru"),
                        answer.printed().stripTrailing());
        printed.add(new Diagnostic(0, 0, said));
    }

    /**
     * Asks for every answer once more, in another order; what such a call printed is dropped.
     *
     * @return the cases in which an answer differs from the first
     */
    List<CaseTrial> repeat(List<CaseTrial> cases) throws ChildLost, InterruptedException {
        Map<TriedCall, TriedCall> differing = new IdentityHashMap<>();
        student.beginAnew();
        for (TriedCall first : answered(cases)) {
            if (student.over().isPresent()) break;
            TriedCall second = student.call(first.call());
            if (second.answer().isPresent()) repeated.add(first.call());
            if (!first.isRepeatedBy(second)) differing.put(first, notRepeatable(first.call()));
        }
        Map<Case, CaseTrial> changed = new LinkedHashMap<>();
        for (CaseTrial tried : cases)
            if (tried.calls().stream().anyMatch(differing::containsKey))
                changed.put(tried.one(), tried.with(differing));
        return List.copyOf(changed.values());
    }

    /** The calls that were answered, in the order in which they are asked once more. */
    List<TriedCall> answered(List<CaseTrial> cases) {
        List<TriedCall> all = new ArrayList<>();
        for (CaseTrial tried : cases)
            for (TriedCall call : tried.calls()) if (call.answer().isPresent()) all.add(call);
        Collections.shuffle(all, new Random(~seed));
        return all;
    }

    /** The calls that were answered both times, in the order of the second. */
    List<GradedCall> repeated() {
        return repeated;
    }

    private static TriedCall notRepeatable(GradedCall call) {
        return TriedCall.failed(
                call,
                Finding.of(
                        GradingVerdict.WRONG,
                        Message.of("mistake.not-repeatable").and(call.example())));
    }
}
