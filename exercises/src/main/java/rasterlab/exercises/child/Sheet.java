package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import rasterlab.contract.Pixels;

/**
 * The sheet that a student's method draws on keeps every pixel in order, up to a limit. It is the
 * same, and a fresh one, for every call, so that nothing tells a method whether it is timed.
 */
final class Sheet implements Pixels {
    /** Ends a method that goes on beyond the limit. */
    private static final class Full extends Error {
        private static final long serialVersionUID = 1L;

        Full() {
            super("too many pixels", null, false, false);
        }
    }

    private final int most;
    private int[] cells;
    private int size;
    private boolean full;

    Sheet(int limit) {
        this(limit, Math.min(limit, 256));
    }

    /**
     * @param limit the most pixels
     * @param room for so many pixels from the start, so that making more takes no time later
     */
    Sheet(int limit, int room) {
        most = 2 * limit;
        cells = new int[2 * Math.min(limit, room)];
    }

    @Override
    public void plot(int x, int y) {
        int i = size;
        if (i == cells.length) makeRoom();
        cells[i] = x;
        cells[i + 1] = y;
        size = i + 2;
    }

    /** Apart from the drawing, which a student's method repeats for each pixel. */
    private void makeRoom() {
        if (size == most) stop();
        cells = Arrays.copyOf(cells, Math.min(most, 2 * size));
    }

    /** Throws once; a method that swallows that and plots on ends the process. */
    private void stop() {
        if (full) Runtime.getRuntime().halt(Wire.EXIT_OUTPUT);
        full = true;
        throw new Full();
    }

    boolean full() {
        return full;
    }

    /** Adds all pixels to a sum. */
    void addTo(PixelSum sum) {
        for (int i = 0; i < size; i += 2) sum.plot(cells[i], cells[i + 1]);
    }

    /** Writes the number of pixels, then x and y of each. */
    void writeTo(DataOutputStream out) throws IOException {
        out.writeInt(size / 2);
        for (int i = 0; i < size; i++) out.writeInt(cells[i]);
    }
}
