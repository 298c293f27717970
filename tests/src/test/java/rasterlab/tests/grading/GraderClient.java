package rasterlab.tests.grading;

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
import java.util.stream.Stream;

/**
 * Speaks the HTTP API as one person.
 *
 * @param token empty for somebody who has none
 */
public record GraderClient(HttpClient http, URI address, String token) {
    private static final Duration LIMIT = Duration.ofMinutes(2);
    private static final ObjectMapper JSON = new ObjectMapper();

    public static GraderClient of(URI address, String token) {
        return new GraderClient(HttpClient.newHttpClient(), address, token);
    }

    GraderClient as(String otherToken) {
        return new GraderClient(http, address, otherToken);
    }

    HttpResponse<String> send(HttpRequest.Builder request)
            throws IOException, InterruptedException {
        return http.send(request.build(), BodyHandlers.ofString());
    }

    HttpRequest.Builder request(String path) {
        var request = HttpRequest.newBuilder(address.resolve("/api/v1" + path)).timeout(LIMIT);
        return token.isEmpty() ? request : request.header("Authorization", "Bearer " + token);
    }

    public JsonNode post(String path, String json) throws IOException, InterruptedException {
        var response =
                send(
                        request(path)
                                .header("Content-Type", "application/json")
                                .POST(BodyPublishers.ofString(json)));
        return expect(201, response);
    }

    JsonNode get(String path) throws IOException, InterruptedException {
        return expect(200, send(request(path)));
    }

    /** Joins a new course as a new student, and returns that student's client. */
    GraderClient joinNewCourse() throws IOException, InterruptedException {
        var code = post("/courses", "{\"name\":\"Computer graphics\"}").path("code").asText();
        var joined = as("").post("/join", "{\"course\":\"%s\",\"name\":\"Ada\"}".formatted(code));
        return as(joined.path("token").asText());
    }

    /** Submits a source and returns the submission's id. */
    String submit(String exercise, String source) throws IOException, InterruptedException {
        var response =
                send(
                        request("/exercises/" + exercise + "/submissions")
                                .header("Content-Type", "text/x-java-source")
                                .POST(BodyPublishers.ofString(source)));
        return expect(202, response).path("id").asText();
    }

    /** Follows the submission's events until it is done, then reads its result. */
    JsonNode result(String id) throws IOException, InterruptedException {
        awaitEvent(id, "event: done");
        return get("/submissions/" + id);
    }

    /** Follows the submission's events up to the first line that has these words. */
    void awaitEvent(String id, String words) throws IOException, InterruptedException {
        HttpResponse<Stream<String>> events =
                http.send(
                        request("/submissions/" + id + "/events").build(), BodyHandlers.ofLines());
        try (var lines = events.body()) {
            if (lines.noneMatch(line -> line.contains(words)))
                throw new AssertionError("events of " + id + " ended without '" + words + "'");
        }
    }

    static JsonNode expect(int status, HttpResponse<String> response) throws IOException {
        if (response.statusCode() != status)
            throw new AssertionError(
                    response.request().method()
                            + " "
                            + response.uri()
                            + ": expected "
                            + status
                            + ", got "
                            + response.statusCode()
                            + " "
                            + response.body());
        return JSON.readTree(response.body());
    }
}
