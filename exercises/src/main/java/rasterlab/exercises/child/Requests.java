package rasterlab.exercises.child;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * The parent's requests, read by a thread of their own while the last one is answered: the input
 * ends when the parent does, however that happens, and then the child ends too, whatever it is at.
 */
final class Requests {
    private final BlockingQueue<byte[]> frames = new LinkedBlockingQueue<>();

    /**
     * @param atEnd the exit status when there is no parent any more
     */
    Requests(InputStream in, int atEnd) {
        Thread reader = new Thread(() -> read(in, atEnd), "input");
        reader.setDaemon(true);
        reader.start();
    }

    private void read(InputStream in, int atEnd) {
        try {
            while (true) frames.add(Frames.read(in, Wire.MOST_FRAME_BYTES));
        } catch (IOException parentHasGone) {
            Runtime.getRuntime().halt(atEnd);
        }
    }

    /** The next one; waits for it. */
    DataInputStream next() throws IOException {
        try {
            return new DataInputStream(new ByteArrayInputStream(frames.take()));
        } catch (InterruptedException e) {
            throw new IOException("interrupted while waiting for a request", e);
        }
    }
}
