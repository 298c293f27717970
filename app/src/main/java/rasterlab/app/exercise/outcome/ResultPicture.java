package rasterlab.app.exercise.outcome;

import java.util.List;
import java.util.Optional;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PictureBytes;
import rasterlab.exercises.score.PicturePart;
import rasterlab.exercises.score.PixelRows;

/**
 * A picture of a case of a result.
 *
 * @param kind as in the HTTP API
 * @param file the picture as PNG, in each language
 * @param text tells what is there to people who do not see it
 * @param part which pixels of a grid these are; empty where it is no grid, or that is not known
 */
public record ResultPicture(
        String kind, PictureBytes file, LocalizedText text, Optional<PicturePart> part) {
    public ResultPicture {
        if (!CasePicture.isKind(kind))
            throw new IllegalArgumentException("no kind of a picture: '" + kind + "'");
    }

    static ResultPicture of(CasePicture one) {
        return new ResultPicture(
                one.kind(), one.file(), LocalizedText.of(one.text()::in), one.part());
    }

    public boolean isDifference() {
        return kind.equals(CasePicture.DIFFERENCE);
    }

    /** The rows of characters alone; none where it is no grid of pixels. */
    public List<String> rows() {
        return PixelRows.of(text.english(), part);
    }
}
