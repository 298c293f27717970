package rasterlab.app.tour;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import rasterlab.exercises.document.OwnJson;

/** Talks to the grading server as an instructor and a student do. */
final class GraderClient {
    private static final Duration LONGEST_ANSWER = Duration.ofSeconds(20);
    private static final Duration LONGEST_GRADING = Duration.ofMinutes(1);

    private final URI server;
    private final HttpClient http = HttpClient.newHttpClient();

    /**
     * @param server such as http://127.0.0.1:8080
     */
    GraderClient(URI server) {
        this.server = server;
    }

    /** Makes a course and returns the code that students join by. */
    String createCourse(String instructorToken, String name)
            throws IOException, InterruptedException {
        byte[] body = OwnJson.MAPPER.writeValueAsBytes(Map.of("name", name));
        return post("/api/v1/courses", instructorToken, "application/json", body)
                .path("code")
                .asText();
    }

    /** Joins a course and returns the student's token. */
    String join(String code, String name) throws IOException, InterruptedException {
        byte[] body = OwnJson.MAPPER.writeValueAsBytes(Map.of("course", code, "name", name));
        return post("/api/v1/join", "", "application/json", body).path("token").asText();
    }

    /**
     * Submits a source and waits until it is graded.
     *
     * @param language of the messages, "en" or "ru"
     */
    JsonNode graded(String token, String exercise, String source, String language)
            throws IOException, InterruptedException {
        String path = "/api/v1/exercises/" + exercise + "/submissions";
        String id =
                post(path, token, "text/x-java-source", source.getBytes(StandardCharsets.UTF_8))
                        .path("id")
                        .asText();
        awaitDone("/api/v1/submissions/" + id + "/events", token);
        return OwnJson.MAPPER.readTree(
                get("/api/v1/submissions/" + id + "?lang=" + language, token));
    }

    /** Follows a submission's events until the one that says it is done. */
    private void awaitDone(String path, String token) throws IOException, InterruptedException {
        var events = http.sendAsync(request(path, token).GET().build(), BodyHandlers.ofLines());
        var done =
                events.thenApplyAsync(
                        response -> {
                            try (Stream<String> lines = response.body()) {
                                return lines.anyMatch("event: done"::equals);
                            }
                        });
        try {
            if (!done.get(LONGEST_GRADING.toSeconds(), TimeUnit.SECONDS))
                throw new IOException("the events of a submission ended before it was done");
        } catch (TimeoutException e) {
            events.cancel(true);
            throw new IOException("no result within " + LONGEST_GRADING.toSeconds() + " s", e);
        } catch (ExecutionException e) {
            throw new IOException("the events of a submission broke off", e.getCause());
        }
    }

    /** The text that the server has at that address. */
    byte[] get(String path, String token) throws IOException, InterruptedException {
        return answered(request(path, token).GET().build());
    }

    private JsonNode post(String path, String token, String type, byte[] body)
            throws IOException, InterruptedException {
        HttpRequest request =
                request(path, token)
                        .header("Content-Type", type)
                        .POST(BodyPublishers.ofByteArray(body))
                        .build();
        return OwnJson.MAPPER.readTree(answered(request));
    }

    private HttpRequest.Builder request(String path, String token) {
        var builder = HttpRequest.newBuilder(server.resolve(path)).timeout(LONGEST_ANSWER);
        return token.isEmpty() ? builder : builder.header("Authorization", "Bearer " + token);
    }

    private byte[] answered(HttpRequest request) throws IOException, InterruptedException {
        HttpResponse<byte[]> response = http.send(request, BodyHandlers.ofByteArray());
        if (response.statusCode() / 100 == 2) return response.body();
        throw new IOException(
                "%s %s: status %d, %s"
                        .formatted(
                                request.method(),
                                request.uri().getPath(),
                                response.statusCode(),
                                OwnJson.MAPPER.readTree(response.body()).path("detail").asText()));
    }
}
