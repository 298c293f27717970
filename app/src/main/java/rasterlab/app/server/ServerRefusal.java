package rasterlab.app.server;

import java.io.IOException;

/** A server's answer that says no. */
public final class ServerRefusal extends IOException {
    private static final long serialVersionUID = 1L;

    private final int status;
    private final String code;

    /**
     * @param code of the kind of refusal; empty where the server names none
     * @param detail the server's own words
     */
    ServerRefusal(int status, String code, String detail) {
        super(detail);
        this.status = status;
        this.code = code;
    }

    /** An HTTP status. */
    public int status() {
        return status;
    }

    /** The code, such as "unknown-course"; empty where the server names none. */
    public String code() {
        return code;
    }
}
