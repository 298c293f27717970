package rasterlab.app.exercise;

import java.io.EOFException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.SocketException;
import java.net.URI;
import java.net.UnknownHostException;
import java.net.http.HttpConnectTimeoutException;
import java.net.http.HttpTimeoutException;
import java.nio.channels.ClosedChannelException;
import java.util.Objects;
import java.util.stream.Stream;
import rasterlab.app.exercise.JoinAnswer.Field;

/** What a failed talk with a server means to the user. */
final class ServerNotices {
    private static final int UNAUTHORIZED = 401;
    private static final int TOO_MANY = 429;

    private ServerNotices() {}

    /** The notice of a source that could not be handed in. */
    static Notice of(URI server, IOException failure) {
        return told("server", server, failure);
    }

    /** The answer to joining a course: what of the form is to be typed anew, and why. */
    static JoinAnswer joining(URI server, IOException failure) {
        String address = server.toString();
        if (failure instanceof ServerRefusal refusal) {
            if (refusal.status() == UNAUTHORIZED)
                return JoinAnswer.refused(Field.TOKEN, Notice.of("join.token", address));
            if (refusal.code().equals("unknown-course"))
                return JoinAnswer.refused(Field.CODE, Notice.of("join.code", address));
            if (refusal.code().equals("bad-name"))
                return JoinAnswer.refused(Field.NAME, Notice.of("join.name", address));
        }
        return JoinAnswer.refused(Field.ADDRESS, told("join", server, failure));
    }

    /**
     * @param talk begins the keys of what is said of a talk that was not finished
     */
    private static Notice told(String talk, URI server, IOException failure) {
        String address = server.toString();
        if (failure instanceof ServerRefusal refusal) return refused(address, refusal);
        if (failure instanceof HttpConnectTimeoutException
                || failure instanceof ConnectException
                || failure instanceof UnknownHostException)
            return Notice.of(talk + ".down", address);
        if (failure instanceof HttpTimeoutException) return Notice.of(talk + ".slow", address);
        if (isLost(failure)) return Notice.of(talk + ".lost", address);
        String reason = failure.getMessage();
        return Notice.of(talk + ".failed", address, reason == null ? failure.toString() : reason);
    }

    /**
     * Whether the connection ended before the answer did; the client's words are about its parser.
     */
    private static boolean isLost(Throwable failure) {
        return Stream.iterate(failure, Objects::nonNull, Throwable::getCause)
                .anyMatch(
                        each ->
                                each instanceof EOFException
                                        || each instanceof SocketException
                                        || each instanceof ClosedChannelException);
    }

    private static Notice refused(String address, ServerRefusal refusal) {
        return switch (refusal.status()) {
            case UNAUTHORIZED -> Notice.of("server.token", address);
            case TOO_MANY -> Notice.of("server.tooMany", refusal.getMessage());
            default ->
                    Notice.of(
                            "server.refused",
                            address,
                            refusal.getMessage(),
                            String.valueOf(refusal.status()));
        };
    }
}
