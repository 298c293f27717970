package rasterlab.exercises.pixels;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Message;

/**
 * Compares what was drawn with a path and finds the mistakes that lie at its ends: a pixel is
 * missing there, or one more comes. A pixel missing at one end with one more at the other is a
 * single mistake, a path that is shifted along itself.
 *
 * @param wanted the path; of a cut one with one pixel more than was drawn
 * @param cut whether the path goes on, so that its last end is not seen
 * @param first code of the end that is drawn first
 * @param last code of the other
 */
record PixelEnds(
        PixelRecording wanted, PixelRecording actual, boolean cut, String first, String last) {
    /**
     * A fault at an end of a path: so many pixels of the path, or of what was drawn, stand alone.
     */
    private enum Amiss {
        NOTHING(0, 0),
        MISSING(1, 0),
        EXTRA(0, 1);

        private final int wanted;
        private final int drawn;

        Amiss(int wanted, int drawn) {
            this.wanted = wanted;
            this.drawn = drawn;
        }
    }

    /** The explanations with the fewest mistakes, which are none where all is right. */
    List<List<Cause>> explanations() {
        List<List<Cause>> found = new ArrayList<>();
        for (Amiss start : Amiss.values()) {
            if (cut) {
                if (fits(start, Amiss.NOTHING)) found.addAll(atStart(start));
            } else
                for (Amiss end : Amiss.values())
                    if (fits(start, end)) found.add(atBoth(start, end));
        }
        int fewest = found.stream().mapToInt(List::size).min().orElse(0);
        return found.stream()
                .filter(one -> one.size() == fewest)
                .sorted(Comparator.comparing(one -> Cause.codes(one).toString()))
                .toList();
    }

    /** Whether all that lies between is drawn as it should be; at least one pixel does. */
    private boolean fits(Amiss start, Amiss end) {
        boolean lacks = start == Amiss.MISSING || end == Amiss.MISSING;
        if (lacks && wanted.size() < 3) return false;
        int shared = actual.size() - start.drawn - end.drawn;
        int left = wanted.size() - start.wanted - end.wanted;
        if (shared < 1 || (cut ? shared > left : shared != left)) return false;
        for (int i = 0; i < shared; i++) if (!same(start.wanted + i, start.drawn + i)) return false;
        return !comesAgain(start, 0, 0) && !comesAgain(end, wanted.size() - 1, actual.size() - 1);
    }

    /** The end itself, drawn twice, is no pixel beyond it. */
    private boolean comesAgain(Amiss end, int inWanted, int inActual) {
        return end == Amiss.EXTRA && same(inWanted, inActual);
    }

    private boolean same(int inWanted, int inActual) {
        return wanted.x(inWanted) == actual.x(inActual) && wanted.y(inWanted) == actual.y(inActual);
    }

    /** Explains a path whose last end is not seen: it may as well be shifted along itself. */
    private List<List<Cause>> atStart(Amiss start) {
        return switch (start) {
            case NOTHING -> List.of(List.of());
            case MISSING -> List.of(List.of(Cause.of(first)), List.of(along("late")));
            case EXTRA -> List.of(List.of(beyond(first, 0, 0)), List.of(along("early")));
        };
    }

    private List<Cause> atBoth(Amiss start, Amiss end) {
        if (start == Amiss.MISSING && end == Amiss.EXTRA) return List.of(along("late"));
        if (start == Amiss.EXTRA && end == Amiss.MISSING) return List.of(along("early"));
        List<Cause> causes = new ArrayList<>();
        if (start == Amiss.MISSING) causes.add(Cause.of(first));
        if (start == Amiss.EXTRA) causes.add(beyond(first, 0, 0));
        if (end == Amiss.MISSING) causes.add(Cause.of(last));
        if (end == Amiss.EXTRA) causes.add(beyond(last, wanted.size() - 1, actual.size() - 1));
        return causes;
    }

    private static Cause along(String which) {
        return new Cause("shifted", Message.of("mistake.shifted-" + which));
    }

    /** A pixel more, which need not lie beside the end; beyond the range of int it wraps. */
    private Cause beyond(String end, int inWanted, int inActual) {
        boolean beside =
                isNextTo(actual.x(inActual) - wanted.x(inWanted))
                        && isNextTo(actual.y(inActual) - wanted.y(inWanted));
        return beside
                ? Cause.of("beyond-" + end)
                : new Cause("beyond-" + end, Message.of("mistake.beside-" + end));
    }

    private static boolean isNextTo(int difference) {
        return difference >= -1 && difference <= 1;
    }
}
