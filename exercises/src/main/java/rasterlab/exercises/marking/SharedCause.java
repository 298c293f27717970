package rasterlab.exercises.marking;

import static java.util.stream.Collectors.toCollection;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Message;

/** The mistake that every wrong call shows, on which inputs it shows, and one of them. */
final class SharedCause {
    private final List<TriedCase> cases;
    private final List<TriedCall> wrong;
    private final List<TriedCall> right;

    SharedCause(List<TriedCase> cases) {
        this.cases = cases;
        List<TriedCall> all = calls(false);
        List<TriedCall> telling = all.stream().filter(call -> !call.tellsLittle()).toList();
        this.wrong = telling.isEmpty() ? all : telling;
        this.right = calls(true);
    }

    private List<TriedCall> calls(boolean right) {
        return cases.stream()
                .flatMap(tried -> tried.calls().stream())
                .filter(call -> call.right() == right)
                .toList();
    }

    /** Nothing where the failures share no mistake, or where there is but one. */
    Message said() {
        if (wrong.size() < 2) return Message.NONE;
        List<Cause> shared =
                wrong.get(0).finding().explanations().stream()
                        .flatMap(List::stream)
                        .distinct()
                        .filter(this::isEverywhere)
                        .toList();
        if (shared.isEmpty()) return Message.NONE;
        Message said = Message.of("cause.shared");
        for (Cause cause : shared) said = said.and(cause.said());
        return said.and(where()).and(example().orElse(Message.NONE));
    }

    private boolean isEverywhere(Cause cause) {
        return wrong.stream()
                .allMatch(
                        call ->
                                call.finding().explanations().stream()
                                        .anyMatch(known -> known.contains(cause)));
    }

    /** The traits, at most two, that the wrong inputs have and no right one has all of. */
    private Message where() {
        if (right.isEmpty()) return Message.of("where.everywhere");
        List<String> common = common();
        for (String one : common) if (tellsApart(Set.of(one))) return Message.of("where." + one);
        for (int i = 0; i < common.size(); i++)
            for (int j = i + 1; j < common.size(); j++)
                if (tellsApart(Set.of(common.get(i), common.get(j))))
                    return Message.of("where." + common.get(i))
                            .and(Message.of("where." + common.get(j)));
        return Message.NONE;
    }

    private List<String> common() {
        Set<String> traits =
                wrong.get(0).call().traits().stream().collect(toCollection(LinkedHashSet::new));
        wrong.forEach(call -> traits.retainAll(call.call().traits()));
        return List.copyOf(traits);
    }

    private boolean tellsApart(Set<String> traits) {
        return right.stream().noneMatch(call -> call.call().traits().containsAll(traits));
    }

    /** Of a public case: no hidden input may be told. */
    private Optional<Message> example() {
        return cases.stream()
                .filter(TriedCase::open)
                .flatMap(tried -> tried.calls().stream())
                .filter(call -> !call.right())
                .map(call -> call.call().example())
                .findFirst();
    }
}
