package rasterlab.exercises.marking;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.KnownChanges;
import rasterlab.exercises.score.Message;

/**
 * Tells which of several known mistakes a wrong answer shows: those that would make another answer
 * of the program wrong, which is right, were not made.
 */
final class Suspects {
    private final List<GradedCall> right = new ArrayList<>();

    private final ChangedAnswers changed;

    /** Whether a mistake leaves the right answers right, by its code. */
    private final Map<String, Boolean> possible = new HashMap<>();

    Suspects(List<CaseTrial> cases) {
        changed = new ChangedAnswers(cases);
        for (CaseTrial tried : cases)
            for (TriedCall call : tried.calls()) if (call.right()) right.add(call.call());
    }

    /**
     * The mistake that is left of those that explain the answer; nothing where none or several are
     * left, or one is told already.
     */
    Message only(TriedCall wrong, Message told) {
        if (changed.explains(wrong)) return changed.only().orElseThrow().message();
        List<List<Cause>> known = wrong.finding().explanations();
        if (known.size() < 2 || isTold(known, told)) return Message.NONE;
        Optional<List<Cause>> only = Optional.empty();
        for (List<Cause> one : known) {
            if (!one.stream().allMatch(cause -> isPossible(cause.code()))) continue;
            if (one.stream().map(Cause::code).anyMatch(KnownChanges::isOne)) continue;
            if (only.isPresent()) return Message.NONE;
            only = Optional.of(one);
        }
        Message said = Message.NONE;
        for (Cause one : only.orElse(List.of())) said = said.and(one.message());
        return said;
    }

    private static boolean isTold(List<List<Cause>> known, Message told) {
        return known.stream()
                .flatMap(List::stream)
                .flatMap(one -> one.message().sentences().stream())
                .anyMatch(told.sentences()::contains);
    }

    private boolean isPossible(String mistake) {
        return possible.computeIfAbsent(
                mistake, code -> right.stream().allMatch(call -> call.isRightWith(code)));
    }
}
