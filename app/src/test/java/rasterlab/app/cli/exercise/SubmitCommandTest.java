package rasterlab.app.cli.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.server.FakeServer;

/** {@code ./lab submit} with a server that answers as it is told to. */
@Timeout(120)
class SubmitCommandTest {
    private static final String EXERCISE = "GET /api/v1/exercises/line-bresenham";
    private static final String SUBMIT = "POST /api/v1/exercises/line-bresenham/submissions";
    private static final String RESULT = "GET /api/v1/submissions/s1";
    private static final String PART = "{\"xmin\":0,\"ymin\":2,\"xmax\":1,\"ymax\":2}";
    private static final String CASE =
            "{\"name\":\"ties\",\"title\":\"ties\",\"visibility\":\"open\",\"run\":true,"
                    + "\"verdict\":\"%1$s\",\"points\":0,\"of\":4,\"message\":\"pixel (1, 2) is missing\","
                    + "\"pictures\":[{\"kind\":\"difference\",\"url\":\"/x\",\"text\":\"#-\","
                    + "\"part\":{\"shown\":%2$s,\"whole\":%2$s,\"pixel\":{\"x\":1,\"y\":2}}}],"
                    + "\"scene\":null}";
    private static final String DOCUMENT =
            "{\"id\":\"s1\",\"exercise\":\"line-bresenham\",\"revision\":\"0123\",\"attempt\":3,"
                    + "\"verdict\":\"%1$s\",\"points\":{\"accuracy\":8,\"stability\":1,\"speed\":0,"
                    + "\"total\":9,\"of\":100},\"cases\":["
                    + CASE
                    + "],\"diagnostics\":[],\"isolation\":\"bubblewrap\"}";

    @TempDir Path folder;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(folder.resolve("A.java"), "class A {}");
        Files.writeString(folder.resolve("token"), "secret\n");
    }

    private static FakeServer server(String kind, String verdict) throws IOException {
        return new FakeServer()
                .on(
                        EXERCISE,
                        200,
                        "{\"kind\":\"%s\",\"title\":\"A line\",\"revision\":\"0123\",\"points\":{\"total\":100}}"
                                .formatted(kind))
                .on(SUBMIT, 202, "{\"id\":\"s1\",\"state\":\"queued\",\"position\":2}")
                .on(RESULT, 200, DOCUMENT.formatted(verdict, PART))
                .on(
                        RESULT + "/events",
                        exchange ->
                                FakeServer.send(
                                        exchange,
                                        200,
                                        "text/event-stream",
                                        "event: position\ndata: {\"position\":2}\n\nevent: case\ndata: "
                                                + CASE.formatted(verdict, PART)
                                                + "\n\nevent: done\ndata: {}\n\n"));
    }

    private Ran submit(String address, String... more) {
        var words =
                new ArrayList<>(
                        List.of("submit", "line-bresenham", folder.resolve("A.java").toString()));
        words.addAll(List.of("--server", address));
        words.addAll(List.of(more));
        if (Stream.of(more).noneMatch(word -> word.startsWith("--token")))
            words.addAll(List.of("--token-file", folder.resolve("token").toString()));
        return Ran.lab(words.toArray(String[]::new));
    }

    @Test
    void theResultIsToldInWordsAndItsWayBeside() throws IOException {
        try (var server = server("write", "wrong")) {
            Ran ran = submit(server.address());
            assertEquals(1, ran.exitCode(), ran.err());
            assertTrue(ran.err().contains("submitted as submission s1"), ran.err());
            assertTrue(ran.err().contains("place 2 in the queue"), ran.err());
            assertTrue(ran.err().contains("tried: ties"), ran.err());
            assertTrue(ran.out().startsWith("Exercise: A line\nVerdict: wrong\n"), ran.out());
            assertTrue(ran.out().contains("Points: 9 of 100"), ran.out());
            assertTrue(ran.out().contains("Revision of the exercise: 0123"), ran.out());
            assertTrue(ran.out().contains("pixel (1, 2) is missing"), ran.out());
            assertTrue(ran.out().contains("\n  #-\n"), ran.out());
        }
    }

    @Test
    void afterTheDeadlineTheMarkAndTheReasonsAreTold() throws IOException {
        String late =
                DOCUMENT.formatted("wrong", PART)
                        .replace("\"scene\":null", "\"scene\":null,\"why\":\"it asks for ties\"")
                        .replaceFirst("\\{", "{\"late\":true,");
        try (var server = server("write", "wrong").on(RESULT, 200, late)) {
            Ran ran = submit(server.address(), "--late");
            assertTrue(
                    ran.out().contains("\nSubmitted after the deadline: marked as late"),
                    ran.out());
            assertTrue(
                    ran.out().contains("\nWhy this case is there: ties – it asks for ties\n"),
                    ran.out());
        }
    }

    @Test
    void ofJsonNoProgramRunsSoThatNoIsolationIsTold() throws IOException {
        try (var server = server("break", "wrong")) {
            assertFalse(submit(server.address()).out().contains("Isolation"));
        }
    }

    @Test
    void whatIsRightEndsWithZeroAndTheLanguageIsAskedFor() throws IOException {
        try (var server = server("write", "ok")) {
            Ran ran = submit(server.address(), "--lang", "ru");
            assertEquals(0, ran.exitCode(), ran.err());
            assertTrue(ran.out().contains("Вердикт: верно"), ran.out());
            assertTrue(
                    server.asked.stream()
                            .anyMatch(one -> one.path().equals("/api/v1/submissions/s1?lang=ru")),
                    server.asked.toString());
        }
    }

    @Test
    void jsonIsTheServersDocumentAndNothingElse() throws IOException {
        try (var server = server("write", "wrong")) {
            Ran ran = submit(server.address(), "--json");
            var mapper = new ObjectMapper();
            assertEquals(
                    mapper.readTree(DOCUMENT.formatted("wrong", PART)), mapper.readTree(ran.out()));
            assertEquals(1, ran.exitCode(), ran.err());
        }
    }

    @Test
    @DisplayName("what is late is sent without the student's consent, or what is in time with it")
    void consentIsSentWhereItIsGiven() throws IOException {
        try (var server = server("write", "ok")) {
            submit(server.address());
            submit(server.address(), "--late");
            assertEquals(
                    List.of("", "?late=accept"),
                    server.asked.stream()
                            .map(one -> one.path())
                            .filter(path -> path.contains("/submissions") && !path.contains("s1"))
                            .map(path -> path.replaceFirst(".*/submissions", ""))
                            .toList());
        }
    }

    @ParameterizedTest
    @CsvSource({
        "write, text/x-java-source",
        "break, application/json",
        "predict, application/json"
    })
    @DisplayName("inputs and steps are sent as Java")
    void whatIsHandedInIsOfTheKindThatTheServerAsksFor(String kind, String type)
            throws IOException {
        try (var server = server(kind, "ok")) {
            List<String> types = new ArrayList<>();
            server.on(
                    SUBMIT,
                    exchange -> {
                        types.add(exchange.getRequestHeaders().getFirst("Content-Type"));
                        FakeServer.send(exchange, 202, "application/json", "{\"id\":\"s1\"}");
                    });
            submit(server.address()).assertDone();
            assertEquals(List.of(type), types);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "401 | not-signed-in | needs | 2 | does not know the token",
                "409 | late | the deadline was at noon | 2 | after the deadline with --late alone: it is graded like any other attempt, is marked as late and may cost points, as the exercise tells",
                "413 | too-large | the body may have at most 262144 bytes | 2 | at most 262144 bytes (status 413)",
                "415 | kotlin | Kotlin is not accepted; send Java | 2 | Kotlin is not accepted; send Java (status 415)",
                "422 | empty-source | the source is empty | 2 | the source is empty (status 422)",
                "429 | too-fast | at most 10 submissions a minute | 4 | at most 10 submissions a minute (status 429)",
                "503 | storage | the storage does not answer | 4 | the storage does not answer (status 503)",
            })
    void aRefusalIsOneLineWithItsReason(
            int status, String code, String detail, int exit, String said) throws IOException {
        try (var server = server("write", "ok")) {
            server.on(
                    SUBMIT,
                    status,
                    "{\"type\":\"urn:rasterlab:problem:%s\",\"detail\":\"%s\"}"
                            .formatted(code, detail));
            Ran ran = submit(server.address());
            assertTrue(ran.err().contains(said), ran.err());
            assertEquals(1, ran.err().lines().count(), ran.err());
            assertEquals("", ran.out());
            assertEquals(exit, ran.exitCode());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "ru"})
    void anotherServerIsNoGradingServer(String language) throws IOException {
        try (var server = new FakeServer()) {
            Ran ran = submit(server.address(), "--lang", language);
            assertEquals(2, ran.exitCode());
            assertTrue(ran.err().contains("404"), ran.err());
            assertFalse(ran.err().contains("refuses"), ran.err());
            assertEquals(language.equals("ru"), ran.err().contains("сервер проверки"), ran.err());
        }
    }

    @Test
    void noServerIsToldByItsAddress() throws IOException {
        String address;
        try (var taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            address = "http://127.0.0.1:" + taken.getLocalPort();
        }
        submit(address)
                .assertComplains(
                        4,
                        "./lab submit: no answer from "
                                + address
                                + ": is the address right and the server running?");
    }

    @ParameterizedTest
    @ValueSource(strings = {"ftp://x", "http://", "a b"})
    void anAddressThatIsNoneIsTold(String address) {
        submit(address)
                .assertComplains(
                        2,
                        "./lab submit: --server: '"
                                + address
                                + "' is not an address; it looks like http://localhost:8080");
    }

    @Test
    @DisplayName("a bad token stands in the message, where others may read it")
    void aTokenThatIsNoneIsNotRepeated() throws IOException {
        Path file = Files.writeString(folder.resolve("token"), "my secret");
        Ran ran = submit("http://localhost:1");
        ran.assertComplains(
                2,
                "./lab submit: "
                        + file
                        + ": is not a token; one has visible ASCII characters and no spaces");
    }

    @Test
    @DisplayName("a check of another revision passes for one of the server's")
    void anotherRevisionHereIsTold() throws IOException {
        try (var server = server("write", "ok")) {
            Ran ran = submit(server.address());
            assertTrue(ran.err().contains("the server grades revision 0123"), ran.err());
        }
    }

    @Test
    void anExerciseOfOnesOwnFolderHasToBeThere() {
        Ran ran =
                Ran.lab(
                        "submit",
                        "nix",
                        folder.resolve("A.java").toString(),
                        "--server",
                        "http://localhost:1",
                        "--token",
                        "x",
                        "--exercises",
                        folder.toString());
        assertEquals(2, ran.exitCode());
        assertTrue(ran.err().contains("no exercise 'nix'; there are"), ran.err());
    }
}
