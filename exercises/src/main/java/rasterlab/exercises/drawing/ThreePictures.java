package rasterlab.exercises.drawing;

import java.util.List;
import java.util.Optional;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.PictureBytes;

/** Collects what is expected, what is actual, and their difference. */
final class ThreePictures {
    private ThreePictures() {}

    /** The pictures as a report keeps them, in this order. */
    static List<CasePicture> of(
            DrawnPicture expected, DrawnPicture actual, DrawnPicture difference) {
        return List.of(
                expected.called(CasePicture.EXPECTED),
                actual.called(CasePicture.ACTUAL),
                difference.called(CasePicture.DIFFERENCE));
    }

    /**
     * A picture as it was drawn.
     *
     * @param text tells what it shows to people who do not see it
     */
    record DrawnPicture(PictureBytes png, Message text) {
        private CasePicture called(String kind) {
            return new CasePicture(kind, png, text, Optional.empty());
        }
    }
}
