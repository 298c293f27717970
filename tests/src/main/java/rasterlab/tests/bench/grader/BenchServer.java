package rasterlab.tests.bench.grader;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
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
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.Stream;

/** A grading server as {@code ./lab grader serve} starts it, with a course, and who asks it. */
final class BenchServer {
    static final String LISTENING = "listening on ";
    static final String TOKEN = "instructor token: ";
    private static final Duration SHORT = Duration.ofSeconds(5);
    private static final int FOUND = 302;

    private final LabProcess process;
    private final GraderHttp http;
    private final HttpClient browser =
            HttpClient.newBuilder().cookieHandler(new CookieManager()).build();
    private final String course;
    private final String code;

    private BenchServer(LabProcess process) throws IOException, InterruptedException {
        this.process = process;
        this.http = GraderHttp.of(URI.create(process.after(LISTENING)));
        String instructor = process.after(TOKEN);
        JsonNode made = http.newCourse(instructor);
        this.course = made.path("course").asText();
        this.code = made.path("code").asText();
        signIn(instructor);
    }

    private void signIn(String instructor) throws IOException, InterruptedException {
        String token = URLEncoder.encode(instructor, StandardCharsets.UTF_8);
        HttpRequest form =
                http.request("/sign-in", "")
                        .header("Content-Type", "application/x-www-form-urlencoded")
                        .header("Origin", address().resolve("/").toString().replaceAll("/$", ""))
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
     * Starts one on new data.
     *
     * @param folder for what it says on its standard error
     * @param belongings which it is one of from its start
     * @throws IOException when it does not start
     */
    static BenchServer start(LabCall call, BenchFolder folder, Belongings belongings)
            throws IOException, InterruptedException {
        return new BenchServer(
                belongings.add(() -> LabProcess.start(call, folder.errors("server"))));
    }

    URI address() {
        return http.address();
    }

    long pid() {
        return process.pid();
    }

    GraderHttp http() {
        return http;
    }

    /**
     * The status with which somebody is answered who was not connected yet; 0 where there is no
     * answer at all.
     */
    int statusFromAnew() throws InterruptedException {
        var request = HttpRequest.newBuilder(address().resolve("/")).timeout(SHORT).build();
        try {
            return HttpClient.newHttpClient().send(request, BodyHandlers.discarding()).statusCode();
        } catch (IOException unanswered) {
            return 0;
        }
    }

    /** The token of a new student. */
    String join(String name) throws IOException, InterruptedException {
        return http.join(code, name);
    }

    HttpResponse<String> submit(String student, String exercise, String source)
            throws IOException, InterruptedException {
        return http.submit(student, exercise, source);
    }

    /** Waits until a submission is graded, and returns its result. */
    JsonNode graded(String student, String id) throws IOException, InterruptedException {
        return http.graded(student, id);
    }

    /**
     * The nanoseconds until a page has come whole.
     *
     * @throws IOException when it is no page
     */
    long page(String path) throws IOException, InterruptedException {
        long start = System.nanoTime();
        HttpRequest request = http.request(path, "").build();
        int status = browser.send(request, BodyHandlers.ofString()).statusCode();
        if (status != GraderHttp.OK) throw new IOException(path + " was answered with " + status);
        return System.nanoTime() - start;
    }

    /** The most memory that the server's own process had, in MB; empty where nobody tells. */
    OptionalLong mostMemory() throws IOException {
        Path status = ofProcess("status");
        if (!Files.isReadable(status)) return OptionalLong.empty();
        try (Stream<String> lines = Files.lines(status)) {
            return lines.filter(line -> line.startsWith("VmHWM:"))
                    .mapToLong(
                            line -> Long.parseLong(line.replaceAll("\\D", "")) * 1024 / 1_000_000)
                    .findFirst();
        }
    }

    /**
     * How many files the process has open.
     *
     * @throws IOException where the system does not tell
     */
    int openFiles() throws IOException {
        try (Stream<Path> files = Files.list(ofProcess("fd"))) {
            return (int) files.count();
        }
    }

    private Path ofProcess(String file) {
        return Path.of("/proc", String.valueOf(process.pid()), file);
    }
}
