package rasterlab.app.line;

import java.util.Optional;
import java.util.OptionalInt;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Plotted;

/**
 * A segment that a program of the user's was tried on.
 *
 * @param right the method that draws the right line, beside which it belongs
 * @param drawn what it plotted; empty where that was right or is not known
 */
public record TrialSegment(Segment segment, String right, Optional<Plotted> drawn) {
    /** Stands in place of a method's name. */
    static final String NAME = "tried";

    /** Whether it belongs beside what is shown: the right line of that segment alone. */
    boolean fits(LineChoice choice) {
        return choice.equals(new LineChoice(segment, right, ""));
    }

    /** A method that plots the same on that segment. */
    Optional<LineRasterizer> method() {
        return drawn.map(Plotted::pixels)
                .map(
                        pixels ->
                                (x0, y0, x1, y1, out) -> {
                                    for (int i = 0; i < pixels.size(); i++)
                                        out.plot(pixels.x(i), pixels.y(i));
                                });
    }

    /** How many of its pixels are known, where it plotted on; empty where all are. */
    OptionalInt first() {
        return drawn.filter(Plotted::cut)
                .map(plotted -> OptionalInt.of(plotted.pixels().size()))
                .orElse(OptionalInt.empty());
    }

    /** The pixels of a line with which its pixels can be compared: as many as are known of them. */
    PixelRecording comparable(PixelRecording line) {
        if (first().isEmpty() || line.size() == 0) return line;
        var beginning = new PixelRecording(line.size());
        for (int i = 0; i < Math.min(first().getAsInt(), line.size()); i++)
            beginning.plot(line.x(i), line.y(i));
        return beginning;
    }
}
