package rasterlab.tests.bench.grader;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.CookieManager;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A grading server as {@code ./lab grader serve} starts it, with a course, and who asks it. */
final class BenchServer implements AutoCloseable {
    private static final String LISTENING = "listening on ";
    private static final String TOKEN = "instructor token: ";
    private static final Duration LIMIT = Duration.ofMinutes(5);
    private static final Duration SHORT = Duration.ofSeconds(5);
    private static final int STOP_SECONDS = 60;
    private static final int FOUND = 302;
    private static final ObjectMapper JSON = new ObjectMapper();

    private final Path data;
    private final Process process;
    private final HttpClient http = HttpClient.newHttpClient();
    private final HttpClient browser =
            HttpClient.newBuilder().cookieHandler(new CookieManager()).build();
    private final URI address;
    private final String instructor;
    private final String course;
    private final String code;

    private BenchServer(Path data, Process process, URI address, String instructor)
            throws IOException, InterruptedException {
        this.data = data;
        this.process = process;
        this.address = address;
        this.instructor = instructor;
        var made = send(json("/api/v1/courses", instructor, "{\"name\":\"Bench\"}"));
        this.course = JSON.readTree(made.body()).path("course").asText();
        this.code = JSON.readTree(made.body()).path("code").asText();
        signIn();
    }

    private void signIn() throws IOException, InterruptedException {
        String token = URLEncoder.encode(instructor, StandardCharsets.UTF_8);
        HttpRequest form =
                request("/sign-in", "")
                        .header("Content-Type", "application/x-www-form-urlencoded")
                        .header("Origin", address.resolve("/").toString().replaceAll("/$", ""))
                        .POST(BodyPublishers.ofString("token=" + token))
                        .build();
        int status = browser.send(form, BodyHandlers.discarding()).statusCode();
        if (status != FOUND) throw new IOException("signing in was answered with " + status);
    }

    /** The pages that are read while students submit. */
    List<String> pages() {
        return List.of("/instructor", "/instructor/courses/" + course + "/students");
    }

    /**
     * Starts one that limits nobody but by its own strength.
     *
     * @param home folder of the program
     * @throws IOException when it does not start
     */
    static BenchServer start(Path home) throws IOException, InterruptedException {
        Path data = Files.createTempDirectory("rasterlab-bench-server");
        List<String> command = new ArrayList<>(List.of(home.resolve("lab").toString()));
        command.addAll(List.of("grader", "serve", "--port", "0"));
        command.addAll(List.of("--data", data.resolve("course").toString()));
        command.addAll(List.of("--entries-per-minute", "100000"));
        command.addAll(List.of("--submissions-per-minute", "100000", "--waiting", "100000"));
        Process process =
                new ProcessBuilder(command).redirectError(data.resolve("errors").toFile()).start();
        Runtime.getRuntime().addShutdownHook(new Thread(process::destroy));
        var lines =
                new BufferedReader(
                        new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        URI address = URI.create(after(LISTENING, lines));
        return new BenchServer(data, process, address, after(TOKEN, lines));
    }

    private static String after(String words, BufferedReader lines) throws IOException {
        for (String line = lines.readLine(); line != null; line = lines.readLine())
            if (line.startsWith(words)) return line.substring(words.length());
        throw new IOException("the server ended before it said '" + words.strip() + "'");
    }

    URI address() {
        return address;
    }

    /**
     * The status with which somebody is answered who was not connected yet; 0 where there is no
     * answer at all.
     */
    int statusFromAnew() throws InterruptedException {
        var request = HttpRequest.newBuilder(address.resolve("/")).timeout(SHORT).build();
        try {
            return HttpClient.newHttpClient().send(request, BodyHandlers.discarding()).statusCode();
        } catch (IOException unanswered) {
            return 0;
        }
    }

    /** The token of a new student. */
    String join(String name) throws IOException, InterruptedException {
        String body = "{\"course\":\"%s\",\"name\":\"%s\"}".formatted(code, name);
        return JSON.readTree(send(json("/api/v1/join", "", body)).body()).path("token").asText();
    }

    HttpResponse<String> submit(String student, String exercise, String source)
            throws IOException, InterruptedException {
        return send(
                request("/api/v1/exercises/" + exercise + "/submissions", student)
                        .header("Content-Type", "text/x-java-source")
                        .POST(BodyPublishers.ofString(source)));
    }

    /** The id in the answer to what was handed in. */
    static String id(HttpResponse<String> accepted) throws IOException {
        return JSON.readTree(accepted.body()).path("id").asText();
    }

    /** Waits until a submission is graded, and returns its result. */
    JsonNode graded(String student, String id) throws IOException, InterruptedException {
        HttpResponse<Stream<String>> events =
                http.send(
                        request("/api/v1/submissions/" + id + "/events", student).build(),
                        BodyHandlers.ofLines());
        try (var lines = events.body()) {
            lines.anyMatch(line -> line.contains("event: done"));
        }
        return JSON.readTree(send(request("/api/v1/submissions/" + id, student)).body());
    }

    /**
     * The nanoseconds until a page has come whole.
     *
     * @throws IOException when it is no page
     */
    long page(String path) throws IOException, InterruptedException {
        long start = System.nanoTime();
        int status = browser.send(request(path, "").build(), BodyHandlers.ofString()).statusCode();
        if (status != 200) throw new IOException(path + " was answered with " + status);
        return System.nanoTime() - start;
    }

    /** The most memory that the server's own process had, in MB; empty where nobody tells. */
    OptionalLong mostMemory() throws IOException {
        Path status = Path.of("/proc", String.valueOf(process.pid()), "status");
        if (!Files.isReadable(status)) return OptionalLong.empty();
        try (Stream<String> lines = Files.lines(status)) {
            return lines.filter(line -> line.startsWith("VmHWM:"))
                    .mapToLong(
                            line -> Long.parseLong(line.replaceAll("\\D", "")) * 1024 / 1_000_000)
                    .findFirst();
        }
    }

    private HttpRequest.Builder request(String path, String token) {
        var request = HttpRequest.newBuilder(address.resolve(path)).timeout(LIMIT);
        return token.isEmpty() ? request : request.header("Authorization", "Bearer " + token);
    }

    private HttpRequest.Builder json(String path, String token, String body) {
        return request(path, token)
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(body));
    }

    private HttpResponse<String> send(HttpRequest.Builder request)
            throws IOException, InterruptedException {
        return http.send(request.build(), BodyHandlers.ofString());
    }

    /** Ends the server and removes its data. */
    @Override
    public void close() throws IOException {
        process.destroy();
        try {
            if (!process.waitFor(STOP_SECONDS, TimeUnit.SECONDS)) process.destroyForcibly();
        } catch (InterruptedException hurried) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
        try (Stream<Path> all = Files.walk(data)) {
            for (Path one : all.sorted(Comparator.reverseOrder()).toList())
                Files.deleteIfExists(one);
        }
    }
}
