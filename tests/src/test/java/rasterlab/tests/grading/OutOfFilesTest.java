package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Clients that take every file which the server may open do no damage that lasts. */
@Tag("slow")
@EnabledOnOs(value = OS.LINUX, disabledReason = "open files are counted in /proc")
@Timeout(300)
class OutOfFilesTest {
    private static final String EXERCISE = "line-bresenham";

    /**
     * Files beyond those at rest: fewer than the connections that are let in take. A connection
     * takes three, so one comes that finds two, for itself but for no end at the engine.
     */
    private static final int ROOM = 26;

    private static final String END = "\r\n\r\n";
    private static final Pattern LENGTH = Pattern.compile("Content-Length: (\\d+)");
    private static final int REFUSALS = 4;
    private static final int PATIENCE_MILLIS = 30_000;

    @Test
    @DisplayName("after its files ran out the server answers no more, or by faults only")
    void answersAndGradesAfterwards(@TempDir Path folder) throws Exception {
        int most = filesAtRest(folder.resolve("free")) + ROOM;
        try (var server = ServerProcess.withFiles(most, folder.resolve("course"))) {
            var student = GraderClient.of(server.address(), server.token()).joinNewCourse();
            exhaust(server.address());
            String answer =
                    Stream.generate(() -> asked(server.address(), "/healthz"))
                            .filter(each -> each.contains(" 200 "))
                            .findFirst()
                            .orElseThrow();
            assertTrue(answer.startsWith("HTTP/1.1 200 "), answer);
            assertTrue(asked(server.address(), "/nothing").contains(" 404 "));
            assertTrue(asked(server.address(), "/api/v1/exercises").contains(" 401 "));
            var id = student.submit(EXERCISE, Solutions.source(Solutions.RIGHT));
            assertEquals("ok", student.result(id).path("verdict").asText());
        }
    }

    /** How many files a server has open that has graded and waits. */
    private static int filesAtRest(Path data) throws Exception {
        try (var server = ServerProcess.start(data)) {
            var student = GraderClient.of(server.address(), server.token()).joinNewCourse();
            student.result(student.submit(EXERCISE, Solutions.source(Solutions.RIGHT)));
            var open = Path.of("/proc", String.valueOf(server.process().pid()), "fd");
            try (var files = Files.list(open)) {
                return (int) files.count();
            }
        }
    }

    /** Opens connections until some are refused for want of files, provokes errors, closes all. */
    private static void exhaust(URI address) throws IOException {
        List<Socket> open = new ArrayList<>();
        try {
            int refused = 0;
            while (refused < REFUSALS) {
                Socket socket = connect(address);
                open.add(socket);
                String answer = ask(socket, "/healthz");
                if (answer.contains(" 200 ")) continue;
                refused++;
                assertFalse(
                        answer.contains("too-many-connections"), "counted, before files ran out");
            }
            String error = ask(open.get(0), "/nothing-at-all");
            assertTrue(error.startsWith("HTTP/1.1 404 "), "without a file left: " + error);
            String ready = ask(open.get(0), "/readyz");
            assertTrue(ready.matches("(?s)HTTP/1.1 (200|503) .*"), "without a file left: " + ready);
        } finally {
            for (Socket socket : open) socket.close();
        }
    }

    private static String asked(URI address, String target) {
        try (Socket socket = connect(address)) {
            return ask(socket, target);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Socket connect(URI address) throws IOException {
        var socket = new Socket(address.getHost(), address.getPort());
        socket.setSoTimeout(PATIENCE_MILLIS);
        return socket;
    }

    /** The answer's head, and its body where its length is told; nothing where none comes. */
    private static String ask(Socket socket, String target) throws IOException {
        try {
            var request = "GET " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
            socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
            var in = socket.getInputStream();
            var head = new StringBuilder();
            for (int next = in.read(); next >= 0; next = in.read()) {
                head.append((char) next);
                if (head.length() > 3 && head.substring(head.length() - 4).equals(END)) break;
            }
            Matcher length = LENGTH.matcher(head);
            int rest = length.find() ? Integer.parseInt(length.group(1)) : 0;
            return head + new String(in.readNBytes(rest), StandardCharsets.UTF_8);
        } catch (SocketException reset) {
            return "";
        }
    }
}
