package rasterlab.app;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;

/** Remembers why it could not write, which a {@link java.io.PrintStream} above it does not tell. */
final class WatchedOutput extends FilterOutputStream {
    private IOException loss;

    WatchedOutput(OutputStream out) {
        super(out);
    }

    /**
     * Why something was not written; empty also where the reader has gone, as {@code head} does
     * when it has seen enough.
     */
    Optional<String> loss() {
        return Optional.ofNullable(loss)
                .map(IOException::getMessage)
                .filter(reason -> !reason.contains("Broken pipe"));
    }

    @Override
    public void write(int value) throws IOException {
        write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
        try {
            out.write(bytes, from, count);
        } catch (IOException e) {
            if (loss == null) loss = e;
            throw e;
        }
    }
}
