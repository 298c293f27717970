package rasterlab.exercises.score;

import java.util.Optional;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelSet;

/**
 * A wrong case as pictures.
 *
 * @param text rows of characters: {@code #} right, {@code +} extra, {@code -} missing, {@code .}
 *     empty
 * @param expectedPng the exact picture, PNG
 * @param actualPng what was drawn, PNG
 * @param differencePng missing, extra and right pixels told apart by shape and colour, PNG; a right
 *     one that is drawn again or out of turn is crossed out
 */
public record CasePictures(
        String text, byte[] expectedPng, byte[] actualPng, byte[] differencePng) {
    /**
     * The difference as pictures; none where no pixel is expected or drawn.
     *
     * @param amiss pixels that are right, but drawn again or out of turn
     */
    public static Optional<CasePictures> of(PixelDifference difference, PixelSet amiss) {
        return difference
                .shown(amiss)
                .map(
                        shown -> {
                            GridPicture grid = new GridPicture(shown);
                            return new CasePictures(
                                    difference.text(amiss),
                                    grid.lit(difference.right(), difference.missing()),
                                    grid.lit(difference.right(), difference.extra()),
                                    grid.difference(difference, amiss));
                        });
    }
}
