package rasterlab.app.study;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rasterlab.engine.study.Topic;

/** A view of the tab of speed and accuracy: a front by one of the costs, or hazards. */
public enum StudyView {
    CHART(Optional.of(StudyCost.TIME)),
    OPERATIONS(Optional.of(StudyCost.OPERATIONS)),
    PARTS(Optional.of(StudyCost.PARTS)),
    HAZARDS(Optional.empty());

    private final Optional<StudyCost> cost;

    StudyView(Optional<StudyCost> cost) {
        this.cost = cost;
    }

    /** Lower-case name, the key of its texts. */
    String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The cost that is charted; empty for the table of hazards. */
    Optional<StudyCost> cost() {
        return cost;
    }

    boolean isChart() {
        return cost.isPresent();
    }

    /** Whether there is such a view of that topic. */
    boolean isPossible(Topic<?, ?, ?> topic) {
        return cost.map(one -> one.isPossible(topic)).orElse(true);
    }

    /** The views of that topic. */
    static List<StudyView> of(Topic<?, ?, ?> topic) {
        return Arrays.stream(values()).filter(view -> view.isPossible(topic)).toList();
    }
}
