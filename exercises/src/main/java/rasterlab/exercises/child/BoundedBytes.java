package rasterlab.exercises.child;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/** Bytes up to a limit; a writer is stopped before the first one beyond it is kept. */
final class BoundedBytes extends OutputStream {
    /** Stops the writer. */
    static final class Beyond extends IOException {
        private static final long serialVersionUID = 1L;

        Beyond() {
            super("more bytes than are taken");
        }
    }

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final int most;

    BoundedBytes(int most) {
        this.most = most;
    }

    @Override
    public void write(int one) throws IOException {
        requireRoom(1);
        bytes.write(one);
    }

    @Override
    public void write(byte[] some, int from, int length) throws IOException {
        requireRoom(length);
        bytes.write(some, from, length);
    }

    private void requireRoom(int length) throws IOException {
        if (length > most - bytes.size()) throw new Beyond();
    }

    byte[] toByteArray() {
        return bytes.toByteArray();
    }
}
