package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;

/** A method whose steps can be looked at: filling and stepping drain the same walk. */
public interface SteppedFill extends TracedFill {
    /**
     * A walk that fills the picture run by run as it goes.
     *
     * @throws IllegalArgumentException as {@code fill} does
     */
    FillWalk walk(PixelGrid picture, int x, int y, int with, int connectivity);

    @Override
    default void trace(
            PixelGrid picture, int x, int y, int with, int connectivity, FillObserver observer) {
        FillWalk walk = walk(picture, x, y, with, connectivity);
        while (walk.advance()) observer.onRun(walk.y(), walk.from(), walk.to(), walk.waiting());
    }

    @Override
    default String waitingMeans() {
        return "how many places wait on the stack to be looked at";
    }

    @Override
    default void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        FillWalk walk = walk(picture, x, y, with, connectivity);
        boolean more = walk.advance();
        while (more) more = walk.advance();
    }
}
