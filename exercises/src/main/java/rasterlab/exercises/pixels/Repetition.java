package rasterlab.exercises.pixels;

import java.util.Optional;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Message;

/** Pixels of a path that are drawn several times, one right after the other. */
final class Repetition {
    private final PixelRecording actual;

    /** The number of times that each pixel of {@link #once} is drawn. */
    private final int[] times;

    private final PixelRecording once;

    Repetition(PixelRecording actual) {
        this.actual = actual;
        this.times = new int[Math.max(1, actual.size())];
        this.once = new PixelRecording(Math.max(1, actual.size()));
        for (int i = 0; i < actual.size(); i++) {
            if (!repeats(i)) once.plot(actual.x(i), actual.y(i));
            times[once.size() - 1]++;
        }
    }

    private boolean repeats(int i) {
        return i > 0 && actual.x(i) == actual.x(i - 1) && actual.y(i) == actual.y(i - 1);
    }

    /**
     * The mistake, if there is one and without it the path is right.
     *
     * @param wanted the path, of a cut one at least as much as was drawn
     */
    Optional<Cause> explains(PixelRecording wanted, boolean cut, String first, String last) {
        boolean fits =
                once.size() < actual.size()
                        && (cut ? once.size() <= wanted.size() : once.size() == wanted.size());
        if (!fits) return Optional.empty();
        for (int i = 0; i < once.size(); i++)
            if (once.x(i) != wanted.x(i) || once.y(i) != wanted.y(i)) return Optional.empty();
        return Optional.of(
                new Cause("again", Message.of("mistake.again" + which(cut, first, last))));
    }

    private String which(boolean cut, String first, String last) {
        if (once.size() == 1) return times[0] == 2 ? "-each" : "";
        if (actual.size() == once.size() + 1 && times[0] == 2) return "-" + first;
        int end = once.size() - 1;
        if (!cut && actual.size() == once.size() + 1 && times[end] == 2) return "-" + last;
        for (int i = 0; i <= end; i++)
            if (times[i] != 2 && !(cut && i == end && times[i] == 1)) return "";
        return "-each";
    }
}
