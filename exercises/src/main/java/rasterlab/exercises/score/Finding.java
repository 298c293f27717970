package rasterlab.exercises.score;

import java.util.Optional;
import rasterlab.engine.raster.Plotted;

/**
 * What is to be said about one answer.
 *
 * @param said what is wrong; nothing when nothing is
 * @param pictures where something can be shown
 * @param drawn what was plotted, where it is not right
 */
public record Finding(
        GradingVerdict verdict,
        Message said,
        Optional<CasePictures> pictures,
        Optional<Plotted> drawn) {
    public static final Finding OK = of(GradingVerdict.OK, Message.NONE);

    /** A finding without pictures. */
    public static Finding of(GradingVerdict verdict, Message said) {
        return new Finding(verdict, said, Optional.empty(), Optional.empty());
    }
}
