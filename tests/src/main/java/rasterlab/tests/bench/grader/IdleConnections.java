package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;

/** Connections to a server that say nothing, as many as can be opened of those that are wanted. */
final class IdleConnections implements AutoCloseable {
    private final List<SocketChannel> open = new ArrayList<>();

    /** Opens them one after the other, until one is refused. */
    static IdleConnections open(URI server, int wanted) {
        var address = new InetSocketAddress(server.getHost(), server.getPort());
        var all = new IdleConnections();
        for (int k = 0; k < wanted; k++) {
            try {
                all.open.add(SocketChannel.open(address));
            } catch (IOException refused) {
                return all;
            }
        }
        return all;
    }

    int count() {
        return open.size();
    }

    @Override
    public void close() throws IOException {
        for (SocketChannel one : open) one.close();
    }
}
