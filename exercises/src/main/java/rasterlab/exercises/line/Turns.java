package rasterlab.exercises.line;

import java.util.HashSet;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;

/** In which order the pixels of a line are drawn, which a picture of the line does not show. */
record Turns(PixelRecording wanted, PixelRecording actual) {
    /**
     * Pixels that are drawn again; where each is drawn once and they are the right ones, those out
     * of turn.
     */
    PixelRecording amiss(boolean inOrder) {
        var amiss = new PixelRecording(Math.max(1, actual.size()));
        var drawn = new HashSet<Long>();
        for (int i = 0; i < actual.size(); i++)
            if (!drawn.add(key(i))) amiss.plot(actual.x(i), actual.y(i));
        if (inOrder && amiss.size() == 0 && samePixels())
            for (int i = 0; i < actual.size(); i++)
                if (actual.x(i) != wanted.x(i) || actual.y(i) != wanted.y(i))
                    amiss.plot(actual.x(i), actual.y(i));
        return amiss;
    }

    private long key(int i) {
        return (long) actual.x(i) << Integer.SIZE | Integer.toUnsignedLong(actual.y(i));
    }

    private boolean samePixels() {
        PixelSet exact = PixelSet.of(wanted);
        return actual.size() == wanted.size()
                && PixelSet.of(actual).filter((x, y) -> !exact.contains(x, y)).isEmpty();
    }
}
