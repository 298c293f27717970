package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

/** A method that can be watched run by run, even where it cannot be stopped between runs. */
public interface TracedFill extends SeedFiller {
    /**
     * Fills as {@code fill} does and reports each run.
     *
     * @throws IllegalArgumentException as {@code fill} does
     */
    void trace(PixelGrid picture, int x, int y, int with, int connectivity, FillObserver observer);

    /** The waiting count that {@link FillObserver#onRun} gets. */
    String waitingMeans();
}
