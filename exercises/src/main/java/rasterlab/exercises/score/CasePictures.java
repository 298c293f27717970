package rasterlab.exercises.score;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;

/**
 * A wrong case as pictures.
 *
 * @param text rows of characters: {@code #} right, {@code +} extra, {@code -} missing, {@code .}
 *     empty; below a line on the part where they are not all
 * @param part which pixels these are; not known of pictures that an older version made
 * @param expectedPng the exact picture, PNG
 * @param actualPng what was drawn, PNG
 * @param differencePng missing, extra and right pixels told apart by shape and colour, PNG; a right
 *     one that is drawn again or out of turn is crossed out
 */
public record CasePictures(
        String text,
        Optional<PicturePart> part,
        byte[] expectedPng,
        byte[] actualPng,
        byte[] differencePng) {
    /**
     * The difference as pictures.
     *
     * @param amiss pixels that are right, but drawn again or out of turn
     * @param pixel around which a part is shown where there is no place for all: right, missing or
     *     extra
     */
    public static CasePictures of(PixelDifference difference, PixelSet amiss, Pixel pixel) {
        PixelWindow shown = difference.around(pixel.x(), pixel.y());
        var grid = new GridPicture(shown);
        return new CasePictures(
                difference.text(shown),
                Optional.of(new PicturePart(shown, difference.box().orElseThrow(), pixel)),
                grid.lit(difference.right(), difference.missing()),
                grid.lit(difference.right(), difference.extra()),
                grid.difference(difference, amiss));
    }

    /** The rows of characters alone. */
    public List<String> rows() {
        return part.map(known -> known.rows(text)).orElseGet(() -> text.lines().toList());
    }

    /** The part where something is left out. */
    public Optional<PicturePart> cut() {
        return part.filter(known -> !known.isWhole());
    }
}
