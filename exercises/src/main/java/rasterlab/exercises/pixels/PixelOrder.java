package rasterlab.exercises.pixels;

import java.util.HashSet;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;

/** The order in which pixels are drawn, which a picture of them does not show. */
public record PixelOrder(PixelRecording wanted, PixelRecording actual) {
    /**
     * The pixels that are drawn again; where each is drawn once and they are the right ones, those
     * out of turn.
     *
     * @param difference of the two
     */
    public PixelRecording misplaced(PixelDifference difference) {
        var misplaced = new PixelRecording(Math.max(1, actual.size()));
        var drawn = new HashSet<Long>();
        for (int i = 0; i < actual.size(); i++)
            if (!drawn.add(key(i))) misplaced.plot(actual.x(i), actual.y(i));
        if (misplaced.size() == 0 && difference.isEmpty())
            for (int i = 0; i < actual.size(); i++)
                if (actual.x(i) != wanted.x(i) || actual.y(i) != wanted.y(i))
                    misplaced.plot(actual.x(i), actual.y(i));
        return misplaced;
    }

    private long key(int i) {
        return (long) actual.x(i) << Integer.SIZE | Integer.toUnsignedLong(actual.y(i));
    }
}
