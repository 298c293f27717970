package rasterlab.app.cli.run;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/** Reads lines as bytes and keeps no more of a line than a limit, however long it is. */
final class InputLines {
    private final BufferedInputStream in;
    private final int limit;
    private byte[] line = new byte[1024];
    private int length;
    private boolean tooLong;

    /**
     * @param limit the most bytes of a line, without its end
     */
    InputLines(InputStream in, int limit) {
        this.in = new BufferedInputStream(in, 1 << 16);
        this.limit = limit;
    }

    /** Goes to the next line; false at the end of the input. A last line needs no line end. */
    boolean next() throws IOException {
        length = 0;
        tooLong = false;
        int read = in.read();
        if (read < 0) return false;
        for (; read >= 0 && read != '\n'; read = in.read()) append((byte) read);
        return true;
    }

    private void append(byte value) {
        if (length == limit) {
            tooLong = true;
            return;
        }
        if (length == line.length)
            line = Arrays.copyOf(line, (int) Math.min(limit, 2L * line.length));
        line[length++] = value;
    }

    /** The line's bytes; only the first {@link #length()} count, and only until {@link #next()}. */
    byte[] bytes() {
        return line;
    }

    int length() {
        return length;
    }

    /** Whether the line was longer than the limit; then its bytes are not the whole line. */
    boolean tooLong() {
        return tooLong;
    }

    boolean blank() {
        for (int i = 0; i < length; i++) if (!Character.isWhitespace(line[i])) return false;
        return true;
    }

    /** Whether reading on may have to wait, so that answers should be sent first. */
    boolean drained() throws IOException {
        return in.available() == 0;
    }
}
