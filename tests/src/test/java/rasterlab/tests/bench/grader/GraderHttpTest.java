package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class GraderHttpTest {
    private static final Duration LONG = Duration.ofSeconds(30);

    private final CountDownLatch over = new CountDownLatch(1);
    private final ExecutorService threads = Executors.newCachedThreadPool();
    private HttpServer server;
    private GraderHttp http;

    @BeforeEach
    void start() throws IOException {
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.setExecutor(threads);
        server.createContext("/api/v1/submissions/a", one -> answer(one, "{\"verdict\":\"ok\"}"));
        server.start();
        http = GraderHttp.of(URI.create("http://127.0.0.1:" + server.getAddress().getPort()));
    }

    @AfterEach
    void end() {
        over.countDown();
        server.stop(0);
        threads.shutdownNow();
    }

    @Test
    void returnsTheResultAfterTheEventThatItIsDone() throws Exception {
        events("event: position\ndata: {}\n\nevent: done\ndata: {}\n\n");
        assertEquals("ok", http.graded("s", "a", LONG).path("verdict").asText());
    }

    @Test
    @DisplayName("a server that ends before it has graded has graded")
    void failsWhereTheEventsEndWithoutAResult() {
        events("event: position\ndata: {}\n\n");
        var told = assertThrows(IOException.class, () -> http.graded("s", "a", LONG));
        assertEquals("the events of submission a ended without its result", told.getMessage());
    }

    @Test
    @DisplayName("a submission that is never graded is waited for without end")
    void failsWhereTheEventsDoNotEnd() {
        server.createContext(
                "/api/v1/submissions/a/events",
                one -> {
                    one.sendResponseHeaders(200, 0);
                    one.getResponseBody().write("event: position\n\n".getBytes());
                    one.getResponseBody().flush();
                    await();
                });
        var told =
                assertThrows(
                        IOException.class, () -> http.graded("s", "a", Duration.ofMillis(200)));
        assertEquals("submission a has no result after 0 s", told.getMessage());
    }

    @Test
    @DisplayName("of a server that has gone there is no sentence")
    void saysWhichServerHasGone() {
        server.stop(0);
        var told = assertThrows(IOException.class, () -> http.result("s", "a"));
        String expected = "the server at " + http.address() + " does not answer";
        assertEquals(expected, told.getMessage());
        told = assertThrows(IOException.class, () -> http.graded("s", "a", LONG));
        assertEquals(expected, told.getMessage());
    }

    private void events(String lines) {
        server.createContext("/api/v1/submissions/a/events", one -> answer(one, lines));
    }

    private void await() {
        try {
            over.await();
        } catch (InterruptedException hurried) {
            Thread.currentThread().interrupt();
        }
    }

    private static void answer(HttpExchange one, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        one.sendResponseHeaders(200, bytes.length);
        try (var body = one.getResponseBody()) {
            body.write(bytes);
        }
    }
}
