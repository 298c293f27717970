package rasterlab.exercises.runner.child;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Byte frames on a pipe: a length as four bytes, highest first, then as many bytes. */
public final class Frames {
    private Frames() {}

    public static void write(OutputStream out, byte[] frame) throws IOException {
        byte[] whole = new byte[Integer.BYTES + frame.length];
        whole[0] = (byte) (frame.length >>> 24);
        whole[1] = (byte) (frame.length >>> 16);
        whole[2] = (byte) (frame.length >>> 8);
        whole[3] = (byte) frame.length;
        System.arraycopy(frame, 0, whole, Integer.BYTES, frame.length);
        out.write(whole);
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

    /** Writes bytes preceded by their number. */
    public static void writeBytes(DataOutputStream out, byte[] bytes) throws IOException {
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    /** Reads what {@link #writeBytes} wrote, at most {@code most} bytes. */
    public static byte[] readBytes(DataInputStream in, int most) throws IOException {
        return read(in, most);
    }
}
