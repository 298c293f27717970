package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import rasterlab.contract.Pixels;

/**
 * What a student's method draws on: keeps every pixel in order, up to a limit. It is the same, and
 * a fresh one, for every call, so that nothing tells a method whether it is timed.
 */
final class Sheet implements Pixels {
    /** Ends a method that goes on beyond the limit. */
    private static final class Full extends Error {
        private static final long serialVersionUID = 1L;

        Full() {
            super("too many pixels", null, false, false);
        }
    }

    private final int limit;
    private int[] xs;
    private int[] ys;
    private int size;
    private boolean full;

    Sheet(int limit) {
        this(limit, 256);
    }

    /**
     * @param room for so many pixels from the start, so that making more takes no time later
     */
    Sheet(int limit, int room) {
        this.limit = limit;
        xs = new int[room];
        ys = new int[room];
    }

    @Override
    public void plot(int x, int y) {
        if (size >= limit) stop();
        if (size == xs.length) {
            xs = Arrays.copyOf(xs, 2 * size);
            ys = Arrays.copyOf(ys, 2 * size);
        }
        xs[size] = x;
        ys[size] = y;
        size++;
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
        for (int i = 0; i < size; i++) sum.plot(xs[i], ys[i]);
    }

    /** Writes the number of pixels, then x and y of each. */
    void writeTo(DataOutputStream out) throws IOException {
        out.writeInt(size);
        for (int i = 0; i < size; i++) {
            out.writeInt(xs[i]);
            out.writeInt(ys[i]);
        }
    }
}
