package rasterlab.exercises.score;

import java.util.Optional;

/**
 * What is to be said about one answer.
 *
 * @param said what is wrong; nothing when nothing is
 * @param pictures where something can be shown
 */
public record Finding(GradingVerdict verdict, Message said, Optional<CasePictures> pictures) {
    public static final Finding OK = new Finding(GradingVerdict.OK, Message.NONE, Optional.empty());

    /** A finding without pictures. */
    public static Finding of(GradingVerdict verdict, Message said) {
        return new Finding(verdict, said, Optional.empty());
    }
}
