package rasterlab.app.line;

import java.util.Optional;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;

/**
 * A segment that a program of the user's was tried on.
 *
 * @param right the method that draws the right line, beside which it belongs
 * @param drawn what it plotted, in order; empty where that was right or is not known
 */
public record Tried(Segment segment, String right, Optional<PixelRecording> drawn) {
    /** Stands in place of a method's name. */
    static final String NAME = "tried";

    /** Whether it belongs beside what is shown: the right line of that segment alone. */
    boolean fits(LineChoice choice) {
        return choice.equals(new LineChoice(segment, right, ""));
    }

    /** A method that plots the same on that segment. */
    Optional<LineRasterizer> method() {
        return drawn.map(
                pixels ->
                        (x0, y0, x1, y1, out) -> {
                            for (int i = 0; i < pixels.size(); i++)
                                out.plot(pixels.x(i), pixels.y(i));
                        });
    }
}
