package rasterlab.tests.bench.grader;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Asks a server over its API, as programs do.
 *
 * @param limit how long an answer may take
 */
record GraderHttp(HttpClient http, URI address, Duration limit) {
    static final int OK = 200;
    static final int ACCEPTED = 202;
    private static final Duration PATIENT = Duration.ofMinutes(5);
    private static final int GRADED_MINUTES = 5;
    private static final ObjectMapper JSON = new ObjectMapper();

    static GraderHttp of(URI address) {
        return new GraderHttp(HttpClient.newHttpClient(), address, PATIENT);
    }

    GraderHttp at(URI other) {
        return new GraderHttp(http, other, limit);
    }

    GraderHttp within(Duration shorter) {
        return new GraderHttp(http, address, shorter);
    }

    /** A new course of an instructor: {@code course} and the {@code code} to join it. */
    JsonNode newCourse(String instructor) throws IOException, InterruptedException {
        return read(send(json("/api/v1/courses", instructor, "{\"name\":\"Bench\"}")));
    }

    /** The token of a new student. */
    String join(String code, String name) throws IOException, InterruptedException {
        String body = "{\"course\":\"%s\",\"name\":\"%s\"}".formatted(code, name);
        return read(send(json("/api/v1/join", "", body))).path("token").asText();
    }

    HttpResponse<String> submit(String student, String exercise, String source)
            throws IOException, InterruptedException {
        return send(submission(student, exercise, source));
    }

    /**
     * Hands in so that it may be repeated.
     *
     * @param key what the student calls this one
     */
    HttpResponse<String> submit(String student, String exercise, String source, String key)
            throws IOException, InterruptedException {
        return send(submission(student, exercise, source).header("Idempotency-Key", key));
    }

    private HttpRequest.Builder submission(String student, String exercise, String source) {
        return request("/api/v1/exercises/" + exercise + "/submissions", student)
                .header("Content-Type", "text/x-java-source")
                .POST(BodyPublishers.ofString(source));
    }

    /** The id in the answer to what was handed in. */
    static String id(HttpResponse<String> accepted) throws IOException {
        return read(accepted).path("id").asText();
    }

    /** Whether the server can take submissions and store results. */
    HttpResponse<String> ready() throws IOException, InterruptedException {
        return send(request("/readyz", ""));
    }

    /**
     * Waits until a submission is graded, and returns its result.
     *
     * @throws IOException where the server ends before, or takes more than {@value #GRADED_MINUTES}
     *     minutes
     */
    JsonNode graded(String student, String id) throws IOException, InterruptedException {
        return graded(student, id, Duration.ofMinutes(GRADED_MINUTES));
    }

    /**
     * @param longest time for all events, from the first to the last
     */
    JsonNode graded(String student, String id, Duration longest)
            throws IOException, InterruptedException {
        String told = events(student, id, longest);
        if (!told.contains("event: done"))
            throw new IOException("the events of submission " + id + " ended without its result");
        return result(student, id);
    }

    private String events(String student, String id, Duration longest)
            throws IOException, InterruptedException {
        HttpRequest question = request("/api/v1/submissions/" + id + "/events", student).build();
        CompletableFuture<HttpResponse<String>> events =
                http.sendAsync(question, BodyHandlers.ofString());
        try {
            return events.get(longest.toNanos(), TimeUnit.NANOSECONDS).body();
        } catch (TimeoutException late) {
            String limit = longest.toSeconds() + " s";
            throw new IOException("submission " + id + " has no result after " + limit, late);
        } catch (ExecutionException failed) {
            throw unanswered(failed.getCause());
        } finally {
            events.cancel(true);
        }
    }

    /** The state of a submission, and its result where there is one. */
    JsonNode result(String student, String id) throws IOException, InterruptedException {
        return read(send(request("/api/v1/submissions/" + id, student)));
    }

    HttpRequest.Builder request(String path, String token) {
        var request = HttpRequest.newBuilder(address.resolve(path)).timeout(limit);
        return token.isEmpty() ? request : request.header("Authorization", "Bearer " + token);
    }

    private HttpRequest.Builder json(String path, String token, String body) {
        return request(path, token)
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(body));
    }

    private HttpResponse<String> send(HttpRequest.Builder request)
            throws IOException, InterruptedException {
        try {
            return http.send(request.build(), BodyHandlers.ofString());
        } catch (IOException failed) {
            throw unanswered(failed);
        }
    }

    /** Says so in words; those of the client are none, or of its insides. */
    private IOException unanswered(Throwable failed) {
        return new IOException("the server at " + address + " does not answer", failed);
    }

    private static JsonNode read(HttpResponse<String> answer) throws IOException {
        return JSON.readTree(answer.body());
    }
}
