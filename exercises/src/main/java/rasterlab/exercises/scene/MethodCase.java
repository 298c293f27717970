package rasterlab.exercises.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Plotted;

/**
 * An input of a topic's methods, exactly as {@code ./lab run} takes it.
 *
 * @param topic such as "line"
 * @param method that was called; empty where it was a student's own
 * @param input a JSON object
 * @param drawn what a student's own method plotted; empty where it is not kept
 * @param found how a search found it; empty where none did
 */
public record MethodCase(
        String topic,
        Optional<String> method,
        String input,
        Optional<DrawnPixels> drawn,
        Optional<SearchFinding> found)
        implements SceneFile {
    /** The most pixels that are kept of what was plotted. */
    public static final int MOST_DRAWN = 4096;

    /** A column and a row. */
    public record PlottedPixel(int x, int y) {}

    /**
     * Pixels in the order in which they were plotted.
     *
     * @param pixels at most {@link #MOST_DRAWN}
     * @param cut whether more were plotted, or would have been
     */
    public record DrawnPixels(List<PlottedPixel> pixels, boolean cut) {
        public DrawnPixels {
            pixels = List.copyOf(pixels);
            if (pixels.size() > MOST_DRAWN)
                throw new IllegalArgumentException(
                        "drawn must have at most %d pixels, got %d"
                                .formatted(MOST_DRAWN, pixels.size()));
        }

        /** The first {@link #MOST_DRAWN} pixels. */
        public static DrawnPixels of(Plotted plotted) {
            PixelRecording all = plotted.pixels();
            List<PlottedPixel> first =
                    IntStream.range(0, Math.min(MOST_DRAWN, all.size()))
                            .mapToObj(i -> new PlottedPixel(all.x(i), all.y(i)))
                            .toList();
            return new DrawnPixels(first, plotted.cut() || first.size() < all.size());
        }

        private Plotted plotted() {
            var recording = new PixelRecording(MOST_DRAWN);
            for (PlottedPixel one : pixels) recording.plot(one.x(), one.y());
            return new Plotted(recording, cut);
        }
    }

    /**
     * The remark of a search for hazards on an input.
     *
     * @param verdict that the method earned on it, such as "wrong"
     * @param seed of the search
     */
    public record SearchFinding(String verdict, int seed) {}

    public MethodCase {
        SceneJsonPlace.root(input).object();
    }

    /** An input that no search found. */
    public MethodCase(
            String topic, Optional<String> method, String input, Optional<DrawnPixels> drawn) {
        this(topic, method, input, drawn, Optional.empty());
    }

    /** An input without anything drawn for it. */
    public MethodCase(String topic, Optional<String> method, String input) {
        this(topic, method, input, Optional.empty());
    }

    /** The plotted pixels, as a method would have left them. */
    public Optional<Plotted> plotted() {
        return drawn.map(DrawnPixels::plotted);
    }

    /** This case as text; {@link SceneFile#read} gives back what is equal. */
    public String write() {
        return CaseJson.write(this);
    }
}
