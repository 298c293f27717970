package rasterlab.app.server;

import java.net.URI;

/**
 * A student's place at a grading server.
 *
 * @param server such as http://127.0.0.1:8080
 * @param token the student's secret
 * @param student the name that was given on joining; "" where only a token is known
 */
public record Account(URI server, String token, String student) {
    /** The account without the token, which is nobody else's business. */
    @Override
    public String toString() {
        return server.toString();
    }

    /** Whether a header can hold it, as it can every token. */
    public static boolean isToken(String typed) {
        return typed.matches("[!-~]+");
    }

    /**
     * The server of that address.
     *
     * @param typed as a user types it; http where no scheme is given
     * @throws IllegalArgumentException with the address, where it is none
     */
    public static URI server(String typed) {
        String address = typed.strip();
        if (!address.contains("://")) address = "http://" + address;
        URI server = URI.create(address.replaceFirst("/+$", ""));
        boolean web = "http".equals(server.getScheme()) || "https".equals(server.getScheme());
        if (!web || server.getHost() == null || server.getRawQuery() != null)
            throw new IllegalArgumentException(typed);
        return server;
    }
}
