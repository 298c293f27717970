package rasterlab.contract;

/** Where a filling method sends the runs of pixels it lights, in drawing order. */
@FunctionalInterface
public interface Spans {
    /**
     * Lights the pixels from ≤ x &lt; to of one row.
     *
     * @param y pixel row, grows down
     * @param from first column
     * @param to the column after the last one, greater than {@code from}
     */
    void span(int y, int from, int to);
}
