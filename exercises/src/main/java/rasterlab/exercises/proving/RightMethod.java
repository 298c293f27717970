package rasterlab.exercises.proving;

import java.util.List;

/**
 * A method of the topic that is not known to be faulty, and what it earns.
 *
 * @param promised whether the topic says that it never errs
 * @param accuracy points
 * @param stability points
 * @param failed names of cases that pay it nothing
 * @param refused those of them which it only refuses
 * @param breaking names of cases whose property it breaks
 */
public record RightMethod(
        String name,
        boolean promised,
        int accuracy,
        int stability,
        List<String> failed,
        List<String> refused,
        List<String> breaking) {
    public RightMethod {
        failed = List.copyOf(failed);
        refused = List.copyOf(refused);
        breaking = List.copyOf(breaking);
    }

    boolean isFull() {
        return failed.isEmpty();
    }

    /** Whether it breaks its promise: a refusal does not. */
    boolean errs() {
        return promised && !refused.containsAll(failed);
    }
}
