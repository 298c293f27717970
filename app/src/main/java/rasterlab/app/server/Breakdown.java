package rasterlab.app.server;

import java.io.EOFException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.net.http.HttpConnectTimeoutException;
import java.net.http.HttpTimeoutException;
import java.nio.channels.ClosedChannelException;
import java.util.Objects;
import java.util.stream.Stream;

/** The ways in which a talk with a server can end before it is finished. */
public enum Breakdown {
    /** Nobody answers there. */
    DOWN,
    /** Somebody does, but not in time. */
    SLOW,
    /** The connection ended before the answer did. */
    LOST,
    /** A breakdown told by the failure's own words. */
    OTHER;

    /** The kind of a failure that is no refusal. */
    public static Breakdown of(IOException failure) {
        if (failure instanceof HttpConnectTimeoutException
                || failure instanceof ConnectException
                || failure instanceof UnknownHostException) return DOWN;
        if (failure instanceof HttpTimeoutException) return SLOW;
        return isLost(failure) ? LOST : OTHER;
    }

    /** Whether the causes tell of a lost connection; the client's words are about its parser. */
    private static boolean isLost(Throwable failure) {
        return Stream.iterate(failure, Objects::nonNull, Throwable::getCause)
                .anyMatch(
                        each ->
                                each instanceof EOFException
                                        || each instanceof SocketException
                                        || each instanceof ClosedChannelException);
    }
}
