package rasterlab.exercises.proving;

import java.util.List;

/**
 * A known mistake, and the cases that reject it.
 *
 * @param mistake name of the faulty method or mutant
 * @param mutant whether it is a mutant
 * @param asked whether a case has to reject it
 * @param cases names of those that do
 * @param naming names of those that tell the student this mistake
 * @param properties names of those whose property it breaks
 * @param answers whether it answers wrongly anywhere; where not, its mistake cannot be told
 */
public record Kill(
        String mistake,
        boolean mutant,
        boolean asked,
        List<String> cases,
        List<String> naming,
        List<String> properties,
        boolean answers) {
    public Kill {
        cases = List.copyOf(cases);
        naming = List.copyOf(naming);
        properties = List.copyOf(properties);
    }

    public boolean isRejected() {
        return !cases.isEmpty();
    }

    public boolean isNamed() {
        return !naming.isEmpty() || !answers;
    }
}
