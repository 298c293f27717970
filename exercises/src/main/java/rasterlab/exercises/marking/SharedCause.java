package rasterlab.exercises.marking;

import static java.util.stream.Collectors.toCollection;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.KnownChanges;
import rasterlab.exercises.score.Message;

/**
 * The one or two mistakes that explain every wrong call, on which inputs each shows, and one of
 * them; where none do, a mistake that all wrong calls have beside others.
 */
final class SharedCause {
    private final List<CaseTrial> cases;
    private final List<TriedCall> wrong;
    private final List<TriedCall> right;

    SharedCause(List<CaseTrial> cases) {
        this.cases = cases;
        List<TriedCall> all = calls(false);
        List<TriedCall> telling = telling(all);
        this.wrong = telling.isEmpty() ? all : telling;
        this.right = telling.isEmpty() ? calls(true) : telling(calls(true));
    }

    private List<TriedCall> calls(boolean right) {
        return cases.stream()
                .flatMap(tried -> tried.calls().stream())
                .filter(call -> call.right() == right)
                .toList();
    }

    private static List<TriedCall> telling(List<TriedCall> calls) {
        return calls.stream().filter(call -> !call.tellsLittle()).toList();
    }

    /**
     * The sentence on a shared mistake; nothing where the failures share none, or where the one
     * failure tells its mistake itself.
     */
    Message message() {
        if (wrong.isEmpty()) return Message.NONE;
        Optional<Cause> change = new ChangedAnswers(cases).only();
        if (change.isPresent())
            return wrong.size() < 2
                    ? Message.NONE
                    : Message.of("cause.shared")
                            .and(change.get().message())
                            .and(example().orElse(Message.NONE));
        List<Cause> known = known();
        List<Cause> alone = known.stream().filter(one -> explainAll(List.of(one))).toList();
        if (wrong.size() < 2 && !isLeftAlone(alone)) return Message.NONE;
        if (!alone.isEmpty() && !areGuesses(alone))
            return message("cause.shared", List.of(alone.get(0)));
        if (!alone.isEmpty()) return Message.NONE;
        for (int i = 0; i < known.size(); i++)
            for (int j = i + 1; j < known.size(); j++) {
                List<Cause> two = List.of(known.get(i), known.get(j));
                if (explainAll(two)) return message("cause.shared.two", two);
            }
        for (Cause one : known)
            if (wrong.stream().allMatch(call -> shows(call, List.of(one), known)))
                return message("cause.common", List.of(one));
        return Message.NONE;
    }

    /** The one known mistake that explains every wrong call and leaves every right one right. */
    Message only() {
        List<Cause> alone = known().stream().filter(one -> explainAll(List.of(one))).toList();
        return alone.size() == 1 && isKnown(alone.get(0)) ? alone.get(0).message() : Message.NONE;
    }

    /** Whether one known mistake is left of several that explain the one wrong answer. */
    private boolean isLeftAlone(List<Cause> left) {
        return left.size() == 1
                && isKnown(left.get(0))
                && wrong.get(0).finding().explanations().size() > 1;
    }

    private static boolean isKnown(Cause cause) {
        return cause.message().sentences().get(0).key().startsWith("known-");
    }

    /** Whether they are several known mistakes, of which it cannot be told which was made. */
    private static boolean areGuesses(List<Cause> causes) {
        return causes.size() > 1 && isKnown(causes.get(0));
    }

    /** The causes of all explanations, those of the first wrong call first. */
    private List<Cause> known() {
        Set<Cause> known = new LinkedHashSet<>();
        for (TriedCall call : wrong)
            for (List<Cause> one : call.finding().explanations()) known.addAll(one);
        known.removeIf(one -> KnownChanges.isOne(one.code()));
        return known.stream().filter(this::leavesRightOnesRight).toList();
    }

    /**
     * Whether the cause explains no right answer away; else it is another mistake, which only looks
     * like that one where the answer is wrong.
     */
    private boolean leavesRightOnesRight(Cause cause) {
        return right.stream().allMatch(call -> call.call().isRightWith(cause.code()));
    }

    /** A slip is looked for anew where a mistake of another kind gives the same answer. */
    private boolean explainAll(List<Cause> causes) {
        return wrong.stream()
                .allMatch(
                        call ->
                                call.finding().explanations().stream().anyMatch(causes::containsAll)
                                        || causes.size() == 1
                                                && call.comesBySlip(causes.get(0).code()));
    }

    /** Whether the call has those causes by an explanation out of the given ones. */
    private static boolean shows(TriedCall call, List<Cause> causes, List<Cause> given) {
        return call.finding().explanations().stream()
                .anyMatch(one -> given.containsAll(one) && one.containsAll(causes));
    }

    /** Each cause with where it shows, which is said once where all show there. */
    private Message message(String heading, List<Cause> causes) {
        List<Message> where = new ArrayList<>();
        for (Cause one : causes) where.add(where(one, causes));
        Message said = Message.of(heading);
        for (int i = 0; i < causes.size(); i++) {
            said = said.and(causes.get(i).message());
            boolean saidNext = i + 1 < causes.size() && where.get(i + 1).equals(where.get(i));
            if (!saidNext) said = said.and(where.get(i));
        }
        return said.and(example().orElse(Message.NONE));
    }

    private Message where(Cause cause, List<Cause> causes) {
        List<TriedCall> with =
                wrong.stream()
                        .filter(call -> causes.size() == 1 || shows(call, List.of(cause), causes))
                        .toList();
        List<TriedCall> without = new ArrayList<>(right);
        wrong.stream().filter(call -> !with.contains(call)).forEach(without::add);
        return where(with, without);
    }

    /** The traits, at most two, that those inputs have and none of the others has all of. */
    private static Message where(List<TriedCall> with, List<TriedCall> without) {
        if (with.get(0).inQuestion().traits().isEmpty()) return Message.NONE;
        if (without.isEmpty()) return Message.of("where.everywhere");
        List<String> common = common(with);
        for (String one : common)
            if (tellsApart(Set.of(one), without)) return Message.of("where." + one);
        for (int i = 0; i < common.size(); i++)
            for (int j = i + 1; j < common.size(); j++)
                if (tellsApart(Set.of(common.get(i), common.get(j)), without))
                    return Message.of("where." + common.get(i))
                            .and(Message.of("where." + common.get(j)));
        return Message.NONE;
    }

    private static List<String> common(List<TriedCall> calls) {
        Set<String> traits =
                calls.get(0).inQuestion().traits().stream()
                        .collect(toCollection(LinkedHashSet::new));
        calls.forEach(call -> traits.retainAll(call.inQuestion().traits()));
        traits.remove(TopicGrading.SEVERAL);
        return List.copyOf(traits);
    }

    private static boolean tellsApart(Set<String> traits, List<TriedCall> others) {
        return others.stream().noneMatch(call -> call.inQuestion().traits().containsAll(traits));
    }

    /** The example of a public case: no hidden input may be told. */
    private Optional<Message> example() {
        return cases.stream()
                .filter(CaseTrial::open)
                .flatMap(tried -> tried.calls().stream())
                .filter(call -> !call.right())
                .map(call -> call.inQuestion().example())
                .findFirst();
    }
}
