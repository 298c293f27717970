package rasterlab.app.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Plotted;

/**
 * The input that a program of the user's was tried on, with the pixels that it plotted, as they are
 * kept between runs.
 *
 * @param right the method that draws the right line; "" where no program was tried
 * @param wrong whether pixels of the program are shown
 * @param places of those pixels, x and y by turns
 * @param cut whether the program plotted on
 */
record SavedTrial(Segment segment, String right, boolean wrong, List<Integer> places, boolean cut) {
    /** Pixels that are kept; the first of a program that plotted more. */
    static final int MOST = 4 * LineDrawing.LIMIT;

    private static final SavedTrial NOTHING =
            new SavedTrial(new Segment(0, 0, 0, 0), "", false, List.of(), false);

    SavedTrial {
        places = List.copyOf(places);
        if (places.size() % 2 != 0)
            throw new IllegalArgumentException(
                    "places are x and y by turns, got " + places.size() + " numbers");
    }

    static SavedTrial of(Optional<TrialSegment> tried) {
        return tried.map(SavedTrial::of).orElse(NOTHING);
    }

    private static SavedTrial of(TrialSegment tried) {
        if (tried.drawn().isEmpty())
            return new SavedTrial(tried.segment(), tried.right(), false, List.of(), false);
        PixelRecording pixels = tried.drawn().get().pixels();
        int kept = Math.min(MOST, pixels.size());
        var places = new ArrayList<Integer>(2 * kept);
        for (int i = 0; i < kept; i++) {
            places.add(pixels.x(i));
            places.add(pixels.y(i));
        }
        boolean cut = tried.drawn().get().cut() || kept < pixels.size();
        return new SavedTrial(tried.segment(), tried.right(), true, places, cut);
    }

    /** The figure that it was made of, with the pixels that were kept. */
    Optional<TrialSegment> tried() {
        if (right.isEmpty()) return Optional.empty();
        var pixels = new PixelRecording(Math.max(1, places.size() / 2));
        for (int i = 0; i < places.size(); i += 2) pixels.plot(places.get(i), places.get(i + 1));
        return Optional.of(
                new TrialSegment(
                        segment,
                        right,
                        Optional.of(new Plotted(pixels, cut)).filter(drawn -> wrong)));
    }
}
