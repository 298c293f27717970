package rasterlab.engine.raster;

import java.io.IOException;
import rasterlab.contract.Pixels;
import rasterlab.engine.format.AnswerLimitReached;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;

/**
 * Keeps the pixels of one figure that lie in a window, and stops a method that never ends or that
 * has more to say than one answer may have.
 */
public final class AnsweredPixels implements Pixels {
    /** The most pixels in one answer. */
    public static final int MOST = 10_000_000;

    /** The field that they are written into. */
    public static final Field<?> FIELD =
            Field.required("pixels", Shape.list(Shape.wholes(2))).as(FieldKind.PIXELS);

    /**
     * The name of the thing that is drawn, for complaints.
     *
     * @param noun such as "segment"
     * @param advice how to get fewer pixels
     */
    public record FigureName(String noun, String advice) {}

    private final String method;
    private final FigureName figure;
    private final PixelWindow window;
    private final long mostWrites;
    private final PixelRecording kept = new PixelRecording(MOST);
    private long writes;

    /**
     * @param mostWrites the number of pixels after which the method is taken for endless; at least
     *     twice what the figure has
     */
    public AnsweredPixels(String method, FigureName figure, PixelWindow window, long mostWrites) {
        this.method = method;
        this.figure = figure;
        this.window = window;
        this.mostWrites = mostWrites;
    }

    @Override
    public void plot(int x, int y) {
        keep(x, y);
    }

    /** Returns whether the pixel was in the window and is kept. */
    public boolean keep(int x, int y) {
        if (++writes > mostWrites) throw endless();
        if (!window.contains(x, y)) return false;
        if (kept.size() == MOST) throw tooMany(figure.advice());
        kept.plot(x, y);
        return true;
    }

    public PixelRecording kept() {
        return kept;
    }

    private AnswerLimitReached endless() {
        return new AnswerLimitReached(
                method
                        + " does not end: it sent more than "
                        + mostWrites
                        + " pixels, more than twice what the "
                        + figure.noun()
                        + " has");
    }

    public static AnswerLimitReached tooMany(String advice) {
        return new AnswerLimitReached(
                "the answer has more than "
                        + MOST
                        + " pixels, the most that one answer may have; "
                        + advice);
    }

    /** Writes the field {@code pixels}: [x, y] for each. */
    public static void write(PixelRecording pixels, ValueSink out) throws IOException {
        out.name(FIELD.name());
        out.startArray();
        for (int i = 0; i < pixels.size(); i++) {
            out.startArray();
            out.whole(pixels.x(i));
            out.whole(pixels.y(i));
            out.endArray();
        }
        out.endArray();
    }
}
