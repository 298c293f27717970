package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.fail;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;

/** An expected picture, rows separated by blanks, {@code #} lit, and what is drawn over it. */
final class TextCanvas implements Pixels {
    private final PixelRecording expected = new PixelRecording(10_000);
    private final PixelRecording drawn = new PixelRecording(10_000);

    /** The picture's top left corner is pixel (left, top). */
    TextCanvas(String picture, int left, int top) {
        String[] rows = picture.split(" ");
        for (int y = 0; y < rows.length; y++)
            for (int x = 0; x < rows[y].length(); x++)
                if (rows[y].charAt(x) == '#') expected.plot(left + x, top + y);
    }

    @Override
    public void plot(int x, int y) {
        drawn.plot(x, y);
    }

    boolean matches() {
        return PixelDifference.of(expected, drawn).isEmpty() && drawn.size() == expected.size();
    }

    void assertMatches(String what) {
        if (matches()) return;
        String writes = drawn.size() + " writes for " + expected.size() + " pixels";
        var difference = PixelDifference.of(expected, drawn);
        String first = LineComparison.compare(expected, drawn).first();
        fail(
                what
                        + ": "
                        + first
                        + "; "
                        + writes
                        + "\n"
                        + difference.text(difference.box().orElseThrow()));
    }
}
