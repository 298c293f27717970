package rasterlab.app.outcome;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.function.Supplier;

/** Bytes of which there may be no more than so many. */
final class BoundedStream extends FilterInputStream {
    private final Supplier<Complaint> tooLong;
    private long left;

    /**
     * @param most the bytes that there may be
     * @param tooLong thrown by the reading of one more
     */
    BoundedStream(InputStream in, long most, Supplier<Complaint> tooLong) {
        super(in);
        this.tooLong = tooLong;
        left = most;
    }

    @Override
    public int read() throws IOException {
        int read = super.read();
        if (read >= 0) count(1);
        return read;
    }

    @Override
    public int read(byte[] bytes, int from, int length) throws IOException {
        int read = super.read(bytes, from, length);
        if (read > 0) count(read);
        return read;
    }

    private void count(int read) {
        left -= read;
        if (left < 0) throw tooLong.get();
    }
}
