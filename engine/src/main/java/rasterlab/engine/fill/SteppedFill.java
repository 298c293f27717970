package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

/** A method whose steps can be looked at: filling and stepping drain the same walk. */
public interface SteppedFill extends SeedFiller {
    /**
     * A walk that fills the picture run by run as it goes.
     *
     * @throws IllegalArgumentException as {@code fill} does
     */
    FillWalk walk(PixelGrid picture, int x, int y, int with, int connectivity);

    @Override
    default void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        FillWalk walk = walk(picture, x, y, with, connectivity);
        boolean more = walk.advance();
        while (more) more = walk.advance();
    }
}
