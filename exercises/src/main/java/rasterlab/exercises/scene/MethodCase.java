package rasterlab.exercises.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.raster.PixelRecording;

/**
 * An input of a topic's methods, exactly as {@code ./lab run} takes it.
 *
 * @param topic such as "line"
 * @param method that was called; empty where it was a student's own
 * @param input a JSON object
 * @param drawn what a student's own method plotted, in order, at most {@link #MOST_DRAWN} pixels;
 *     empty where it is not kept
 */
public record MethodCase(
        String topic, Optional<String> method, String input, Optional<List<Pixel>> drawn)
        implements SceneFile {
    /** The most pixels that are kept of what was plotted. */
    public static final int MOST_DRAWN = 4096;

    /** A column and a row. */
    public record Pixel(int x, int y) {
        /** The first {@link #MOST_DRAWN} of a recording. */
        public static List<Pixel> first(PixelRecording drawn) {
            List<Pixel> pixels = new ArrayList<>();
            for (int i = 0; i < Math.min(MOST_DRAWN, drawn.size()); i++)
                pixels.add(new Pixel(drawn.x(i), drawn.y(i)));
            return pixels;
        }
    }

    public MethodCase {
        Place.root(input).object();
        drawn = drawn.map(List::copyOf);
        if (drawn.filter(pixels -> pixels.size() > MOST_DRAWN).isPresent())
            throw new IllegalArgumentException(
                    "drawn must have at most %d pixels, got %d"
                            .formatted(MOST_DRAWN, drawn.get().size()));
    }

    /** An input without anything drawn for it. */
    public MethodCase(String topic, Optional<String> method, String input) {
        this(topic, method, input, Optional.empty());
    }

    /** What was plotted, as a method would have left it. */
    public Optional<PixelRecording> recording() {
        return drawn.map(
                pixels -> {
                    var recording = new PixelRecording(MOST_DRAWN);
                    for (Pixel one : pixels) recording.plot(one.x(), one.y());
                    return recording;
                });
    }

    @Override
    public String write() {
        return CaseJson.write(this);
    }
}
