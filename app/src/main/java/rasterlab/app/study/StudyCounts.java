package rasterlab.app.study;

import java.util.List;
import java.util.TreeSet;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/**
 * The counts of a study, which stand in place of times, per item, as columns of a table.
 *
 * @param names of what was counted, in alphabetical order: the same columns for every study of a
 *     topic
 */
public record StudyCounts(List<String> names) {
    /** How many items one pass over a workload has; they divide the other counts. */
    static final String ITEMS = "items";

    /** How many inputs a workload has. */
    static final String INPUTS = "inputs";

    /** The counts that say how much was measured, not what it took. */
    private static final List<String> AMOUNTS = List.of(ITEMS, INPUTS);

    public StudyCounts {
        names = List.copyOf(names);
    }

    public static StudyCounts of(Study study) {
        var names = new TreeSet<String>();
        for (Measurement measured : study.measurements())
            names.addAll(measured.cost().counts().keySet());
        AMOUNTS.forEach(names::remove);
        return new StudyCounts(List.copyOf(names));
    }

    /**
     * One cell for each name: the count per item as a decimal that reads back exactly and without a
     * needless ".0"; empty where this method has no such count.
     */
    public List<String> cells(Measurement measured) {
        return names.stream().map(name -> cell(measured, name)).toList();
    }

    private static String cell(Measurement measured, String name) {
        Long count = measured.cost().counts().get(name);
        long items = measured.cost().counts().getOrDefault(ITEMS, 0L);
        if (count == null || items == 0) return "";
        return count % items == 0
                ? String.valueOf(count / items)
                : String.valueOf((double) count / items);
    }
}
