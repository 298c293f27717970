package rasterlab.engine.fill;

/** Looks on while a region is filled. */
@FunctionalInterface
public interface FillObserver {
    /**
     * Called after a run of pixels was filled.
     *
     * @param y its row
     * @param from its first column
     * @param to the column after its last one
     * @param waiting places that wait on the method's stack, or calls that wait for this one
     */
    void onRun(int y, int from, int to, int waiting);
}
