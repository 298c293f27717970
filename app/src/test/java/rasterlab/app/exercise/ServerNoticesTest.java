package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.outcome.Notice;

@Timeout(300)
class ServerNoticesTest {
    @ParameterizedTest(
            name = "a server that ends in the middle is told in the words of a parser: {0}")
    @CsvSource({
        "within chunks, 'HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n5\r\nhello\r\n'",
        "within the length, 'HTTP/1.1 200 OK\r\nContent-Length: 50\r\n\r\nhello'",
        "before the answer, ''"
    })
    void lostConnectionIsSaid(String where, String begun) throws IOException {
        try (var listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CompletableFuture.runAsync(() -> answer(listening, begun));
            var server = URI.create("http://127.0.0.1:" + listening.getLocalPort());
            var client = HttpClient.newHttpClient();
            var post =
                    HttpRequest.newBuilder(server).POST(HttpRequest.BodyPublishers.ofString("x"));
            IOException failure =
                    assertThrows(
                            IOException.class,
                            () -> client.send(post.build(), BodyHandlers.ofString()));
            assertEquals(
                    Notice.of("server.lost", server.toString()),
                    ServerNotices.of(server, failure),
                    where);
        }
    }

    private static void answer(ServerSocket listening, String begun) {
        try (Socket talk = listening.accept();
                OutputStream out = talk.getOutputStream()) {
            talk.getInputStream().read(new byte[4096]);
            out.write(begun.getBytes(StandardCharsets.US_ASCII));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }
}
