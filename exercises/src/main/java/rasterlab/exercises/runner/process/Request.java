package rasterlab.exercises.runner.process;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/** Builds one request's payload. */
public final class Request {
    /** Writes the payload. */
    @FunctionalInterface
    public interface Payload {
        void writeTo(DataOutputStream out) throws IOException;
    }

    private final int operation;
    private final Payload payload;

    /**
     * @param operation of {@link rasterlab.exercises.child.Wire}
     */
    public Request(int operation, Payload payload) {
        this.operation = operation;
        this.payload = payload;
    }

    public byte[] frame(long nonce) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeByte(operation);
            out.writeLong(nonce);
            payload.writeTo(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
