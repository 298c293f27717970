package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;

/**
 * Byte frames on a pipe, or one within another: a length as four bytes, highest first, then as many
 * bytes.
 */
public final class Frames {
    private Frames() {}

    public static void write(OutputStream out, byte[] frame) throws IOException {
        ByteBuffer whole = ByteBuffer.allocate(Integer.BYTES + frame.length);
        out.write(whole.putInt(frame.length).put(frame).array());
        out.flush();
    }

    /**
     * Reads one frame.
     *
     * @param most the longest frame to accept in bytes; checked before anything is allocated
     * @throws EOFException at the end of the stream
     * @throws IOException when the announced length is negative or above {@code most}
     */
    public static byte[] read(InputStream in, int most) throws IOException {
        int length = new DataInputStream(in).readInt();
        if (length < 0 || length > most)
            throw new IOException("frame of " + length + " bytes, at most " + most + " allowed");
        byte[] frame = in.readNBytes(length);
        if (frame.length < length) throw new EOFException("frame cut after " + frame.length);
        return frame;
    }
}
