package rasterlab.exercises.marking;

import static java.util.stream.Collectors.toUnmodifiableSet;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.CaseGroup;

/**
 * The mistakes that a group of cases pays for, so that no other case has to. A mistake that the
 * cases named after it did not meet is paid for wherever it is met, or by the first case that meets
 * it, which stands in for them.
 */
final class Charges {
    private final Exercise exercise;
    private final Set<String> charged;
    private final Map<String, String> standIns = new HashMap<>();

    private Charges(Exercise exercise, Collection<CaseTrial> cases) {
        this.exercise = exercise;
        this.charged =
                cases.stream()
                        .flatMap(
                                tried ->
                                        tried.calls().stream()
                                                .map(TriedCall::explanations)
                                                .filter(known -> known.size() == 1)
                                                .flatMap(known -> known.get(0).stream())
                                                .filter(claimedBy(tried.one())::contains))
                        .collect(toUnmodifiableSet());
    }

    /** Charges by which a mistake that its own cases did not meet is paid wherever it is met. */
    static Charges wherever(Exercise exercise, Collection<CaseTrial> cases) {
        return new Charges(exercise, cases);
    }

    /** Charges by which a mistake that its own cases did not meet is paid by the first other. */
    static Charges once(Exercise exercise, Collection<CaseTrial> cases) {
        Charges charges = new Charges(exercise, cases);
        Map<String, String> standIns = new HashMap<>();
        for (CaseTrial tried : cases)
            for (TriedCall call : charges.counted(tried))
                charges.metAlone(call)
                        .forEach(mistake -> standIns.putIfAbsent(mistake, tried.one().name()));
        charges.standIns.putAll(standIns);
        return charges;
    }

    /** Mistakes with cases of their own that explain the call for certain, and were not charged. */
    private List<String> metAlone(TriedCall call) {
        List<List<String>> known = call.explanations();
        if (known.size() != 1) return List.of();
        return known.get(0).stream()
                .filter(mistake -> !charged.contains(mistake))
                .filter(
                        mistake ->
                                exercise.groups().stream()
                                        .anyMatch(group -> group.mistakes().contains(mistake)))
                .toList();
    }

    Set<String> charged() {
        return charged;
    }

    /** Whether all that is wrong there was paid for. */
    boolean explain(TriedCall call) {
        return call.explanations().stream().anyMatch(charged::containsAll);
    }

    private Set<String> claimedBy(Case one) {
        return exercise.group(one).map(CaseGroup::mistakes).orElse(Set.of());
    }

    /**
     * The calls that count for that case and are not right: those of a case on one mistake count
     * where they meet it, as long as half of its calls are right.
     */
    List<TriedCall> counted(CaseTrial tried) {
        List<TriedCall> wrong =
                tried.calls().stream()
                        .filter(call -> !call.right() && !isPaidElsewhere(tried.one(), call))
                        .toList();
        Set<String> claimed = claimedBy(tried.one());
        List<TriedCall> named =
                wrong.stream().filter(call -> call.alwaysCounts() || call.mayBe(claimed)).toList();
        boolean asksForOne = !claimed.isEmpty();
        boolean mostlyRight = 2 * wrong.size() <= tried.calls().size();
        return asksForOne && (mostlyRight || !named.isEmpty()) ? named : wrong;
    }

    /** The first of them. */
    Optional<TriedCall> first(CaseTrial tried) {
        return counted(tried).stream().findFirst();
    }

    private boolean isPaidElsewhere(Case one, TriedCall call) {
        Set<String> claimed = claimedBy(one);
        return call.drewSomething()
                && call.explanations().stream()
                        .filter(known -> known.stream().allMatch(this::isPaid))
                        .anyMatch(known -> known.stream().noneMatch(claimed::contains))
                && call.explanations().stream()
                        .flatMap(List::stream)
                        .noneMatch(mistake -> one.name().equals(standIns.get(mistake)));
    }

    private boolean isPaid(String mistake) {
        return charged.contains(mistake) || standIns.containsKey(mistake);
    }
}
