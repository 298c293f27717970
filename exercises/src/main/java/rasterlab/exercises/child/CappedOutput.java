package rasterlab.exercises.child;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Where a student's System.out goes: the beginning is kept for the report, the rest is counted, and
 * too much ends the process, because an exception could be caught.
 */
final class CappedOutput extends OutputStream {
    private final ByteArrayOutputStream beginning = new ByteArrayOutputStream();
    private long written;
    private boolean dropping;
    private long dropped;

    @Override
    public synchronized void write(int one) {
        write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int from, int length) {
        if (dropping) {
            dropped += length;
            return;
        }
        written += length;
        if (written > Wire.MOST_PRINTED_BYTES) Runtime.getRuntime().halt(Wire.EXIT_OUTPUT);
        int kept = Math.min(length, 4 * Wire.MOST_SHOWN - beginning.size());
        if (kept > 0) beginning.write(bytes, from, kept);
    }

    /** Stops keeping what comes from now on, and allows any amount of it. */
    synchronized void drop() {
        dropping = true;
        dropped = 0;
    }

    /** Ends that; returns how many bytes were dropped. */
    synchronized long keep() {
        dropping = false;
        return dropped;
    }

    /** The output since the last call, cut. */
    synchronized String take() {
        String text = Wire.cut(beginning.toString(StandardCharsets.UTF_8));
        beginning.reset();
        return text;
    }
}
