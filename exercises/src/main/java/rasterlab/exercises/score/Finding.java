package rasterlab.exercises.score;

import java.util.Optional;

/**
 * What is to be said about one answer.
 *
 * @param message what is wrong, one line; empty when nothing is
 * @param pictures where something can be shown
 */
public record Finding(GradingVerdict verdict, String message, Optional<CasePictures> pictures) {
    public static final Finding OK = new Finding(GradingVerdict.OK, "", Optional.empty());

    /** A finding without pictures. */
    public static Finding of(GradingVerdict verdict, String message) {
        return new Finding(verdict, message, Optional.empty());
    }
}
