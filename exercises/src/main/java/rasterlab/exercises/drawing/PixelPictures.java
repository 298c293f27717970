package rasterlab.exercises.drawing;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.PicturePart;

/**
 * Shows a difference of pixels by three grids: the exact pixels, those that were drawn, and
 * missing, extra and right ones told apart by shape and colour. The text of each has a character
 * for each pixel: {@code #} lit, {@code .} empty; in the difference {@code #} right, {@code *}
 * right but drawn again or out of turn, {@code +} extra, {@code -} missing.
 */
public final class PixelPictures {
    private static final char AMISS = '*';

    private final PixelDifference difference;
    private final PicturePart part;

    private PixelPictures(PixelDifference difference, PicturePart part) {
        this.difference = difference;
        this.part = part;
    }

    /**
     * The pictures {@code expected}, {@code actual} and {@code difference}.
     *
     * @param misplaced pixels that are right, but drawn again or out of turn: crossed out in the
     *     difference
     * @param pixel around which a part is shown where there is no place for all: right, missing or
     *     extra
     */
    public static List<CasePicture> of(
            PixelDifference difference, PixelSet misplaced, Pixel pixel) {
        PixelWindow shown = difference.around(pixel.x(), pixel.y());
        var part = new PicturePart(shown, difference.box().orElseThrow(), pixel);
        return new PixelPictures(difference, part).all(misplaced);
    }

    private List<CasePicture> all(PixelSet misplaced) {
        var grid = new GridPicture(part.shown());
        String text = difference.text(part.shown());
        return List.of(
                picture(
                        CasePicture.EXPECTED,
                        grid.lit(difference.right(), difference.missing()),
                        withRows(text, '-', '+')),
                picture(
                        CasePicture.ACTUAL,
                        grid.lit(difference.right(), difference.extra()),
                        withRows(text, '+', '-')),
                picture(
                        CasePicture.DIFFERENCE,
                        grid.difference(difference, misplaced),
                        marked(text, misplaced)));
    }

    /** The difference's text with a sign of their own for pixels that are right, but misplaced. */
    private String marked(String text, PixelSet misplaced) {
        var marked = new StringBuilder(text);
        PixelWindow shown = part.shown();
        int columns = shown.xmax() - shown.xmin() + 1;
        int rows = part.isWhole() ? 0 : text.indexOf('\n') + 1;
        PixelSet seen = misplaced.filter(shown::contains);
        for (int i = 0; i < seen.size(); i++) {
            int row = rows + (seen.y(i) - shown.ymin()) * (columns + 1);
            marked.setCharAt(row + seen.x(i) - shown.xmin(), AMISS);
        }
        return marked.toString();
    }

    /** The difference's text, its rows with one of the two kinds lit and the other one empty. */
    private String withRows(String text, char lit, char empty) {
        int rows = part.isWhole() ? 0 : text.indexOf('\n') + 1;
        return text.substring(0, rows) + text.substring(rows).replace(lit, '#').replace(empty, '.');
    }

    private CasePicture picture(String kind, byte[] png, String text) {
        return new CasePicture(kind, png, Message.rows(text), Optional.of(part));
    }
}
