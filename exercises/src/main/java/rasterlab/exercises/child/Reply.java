package rasterlab.exercises.child;

import java.nio.ByteBuffer;

/** An answer's frame. */
final class Reply {
    private Reply() {}

    /**
     * @param body status and payload
     */
    static byte[] of(long nonce, byte[] body) {
        return ByteBuffer.allocate(Long.BYTES + body.length).putLong(nonce).put(body).array();
    }
}
