package rasterlab.engine.line;

import rasterlab.engine.raster.FirstDifference;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.Deviation;

/**
 * How far a drawn line is from the exact one, as sets of pixels.
 *
 * <p>The worst error is the larger of two distances, each max(|Δx|, |Δy|): from any exact pixel to
 * the nearest drawn one (so gaps count) and from any drawn pixel to the nearest exact one. Where
 * nothing is drawn it is the number of exact pixels. Right pixels that come twice or out of order
 * are no distance away, but still a difference.
 */
final class LineComparison {
    private LineComparison() {}

    static Deviation compare(PixelRecording exact, PixelRecording actual) {
        PixelDifference difference = PixelDifference.of(exact, actual);
        PixelSet missing = difference.missing();
        PixelSet extra = difference.extra();
        return new Deviation(
                difference.worst(exact, actual),
                missing.size(),
                extra.size(),
                exact.size(),
                FirstDifference.of(exact, actual, difference)
                        .map(FirstDifference::toString)
                        .orElse(""));
    }
}
