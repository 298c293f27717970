package rasterlab.app.exercise;

import java.io.IOException;

/** A server's answer that says no. */
final class ServerRefusal extends IOException {
    private static final long serialVersionUID = 1L;

    private final int status;

    /**
     * @param detail the server's own words
     */
    ServerRefusal(int status, String detail) {
        super(detail);
        this.status = status;
    }

    /** An HTTP status. */
    int status() {
        return status;
    }
}
