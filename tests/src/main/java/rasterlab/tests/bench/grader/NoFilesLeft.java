package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Connections that take every file which a server may open: each asks, and then stays. */
final class NoFilesLeft implements ServerFault, AutoCloseable {
    /**
     * Files beyond those at rest, fewer than the connections take that a server lets in: each takes
     * three.
     */
    private static final int ROOM = 26;

    private static final int REFUSALS = 4;
    private static final int PATIENCE_MILLIS = 5_000;
    private static final byte[] QUESTION =
            "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n".getBytes(StandardCharsets.US_ASCII);

    private final Path data;
    private final int most;
    private final List<Socket> open = new ArrayList<>();

    /**
     * @param folder in which the data folder will be
     * @param atRest files that a server has open which has graded and waits
     */
    NoFilesLeft(Path folder, int atRest) {
        data = folder.resolve("course");
        most = atRest + ROOM;
    }

    @Override
    public Path data() {
        return data;
    }

    @Override
    public LabCall of(LabCall plain) {
        return plain.withFiles(most);
    }

    /** Returns when several connections, one after the other, were refused. */
    @Override
    public void begin(BenchServer server) throws IOException {
        int refused = 0;
        while (refused < REFUSALS) if (!isAnswered(connect(server.address()))) refused++;
    }

    private Socket connect(URI server) throws IOException {
        var socket = new Socket(server.getHost(), server.getPort());
        open.add(socket);
        socket.setSoTimeout(PATIENCE_MILLIS);
        return socket;
    }

    private static boolean isAnswered(Socket socket) throws IOException {
        try {
            socket.getOutputStream().write(QUESTION);
            byte[] begin = socket.getInputStream().readNBytes("HTTP/1.1 200".length());
            return new String(begin, StandardCharsets.US_ASCII).endsWith(" 200");
        } catch (SocketException | SocketTimeoutException refused) {
            return false;
        }
    }

    @Override
    public void end() throws IOException {
        for (Socket socket : open) socket.close();
        open.clear();
    }

    @Override
    public void close() throws IOException {
        end();
    }
}
