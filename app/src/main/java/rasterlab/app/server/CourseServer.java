package rasterlab.app.server;

import com.fasterxml.jackson.core.JsonProcessingException;
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
import rasterlab.exercises.document.OwnJson;

/**
 * Talks to a grading server as a student does. Every call ends within some seconds or with the
 * thread's interruption.
 */
public final class CourseServer {
    /** How long the server may keep silent. */
    public record ServerTimeouts(Duration connecting, Duration answering, Duration quiet) {
        /** Events come at least each 15 seconds, if only to say that there is nothing new. */
        public static final ServerTimeouts USUAL =
                new ServerTimeouts(
                        Duration.ofSeconds(5), Duration.ofSeconds(20), Duration.ofSeconds(45));
    }

    /** The code of the refusal of what is handed in late. */
    public static final String LATE = "late";

    /** Begins the type of each problem that a grading server tells. */
    private static final String PROBLEM = "urn:rasterlab:problem:";

    private final URI server;
    private final ServerTimeouts patience;
    private final HttpClient http;

    public CourseServer(URI server, ServerTimeouts patience) {
        this.server = server;
        this.patience = patience;
        http = HttpClient.newBuilder().connectTimeout(patience.connecting()).build();
    }

    /**
     * Joins a course.
     *
     * @param key makes repeating the call give the same student; hard to guess
     */
    public Account join(String code, String name, String key)
            throws IOException, InterruptedException {
        byte[] body = OwnJson.MAPPER.writeValueAsBytes(Map.of("course", code, "name", name));
        HttpRequest request =
                request("/api/v1/join")
                        .header("Content-Type", "application/json")
                        .header("Idempotency-Key", key)
                        .POST(BodyPublishers.ofByteArray(body))
                        .build();
        String token = tree(answered(request)).path("token").asText();
        if (token.isEmpty()) throw new IOException("no token in the answer to /api/v1/join");
        return new Account(server, token, name);
    }

    /**
     * The account of somebody who has a token already.
     *
     * @throws ServerRefusal if the server does not know it
     */
    public Account known(String token) throws IOException, InterruptedException {
        if (!Account.isToken(token)) throw new ServerRefusal(401, "", "no header can hold it");
        get("/api/v1/exercises", token);
        return new Account(server, token, "");
    }

    /**
     * Hands in a source.
     *
     * @param mediaType of what is handed in
     * @param key makes repeating the call give the same submission
     * @param late whether the student agrees that it is marked as late after the deadline
     * @return the submission's id
     * @throws ServerRefusal with the code {@link #LATE} if the deadline has passed without that
     */
    public String submit(
            String token,
            String exercise,
            String mediaType,
            String source,
            String key,
            boolean late)
            throws IOException, InterruptedException {
        String path = "/api/v1/exercises/" + exercise + "/submissions";
        HttpRequest request =
                request(late ? path + "?late=accept" : path, token)
                        .header("Content-Type", mediaType)
                        .header("Idempotency-Key", key)
                        .POST(BodyPublishers.ofByteArray(source.getBytes(StandardCharsets.UTF_8)))
                        .build();
        String id = tree(answered(request)).path("id").asText();
        if (!id.matches("[A-Za-z0-9_-]+"))
            throw new IOException("the server's id of the submission is '" + id + "'");
        return id;
    }

    /** All exercises as the server has them, with how far the student has come. */
    public JsonNode exercises(String token) throws IOException, InterruptedException {
        return tree(get("/api/v1/exercises", token));
    }

    /**
     * An exercise as the server has it.
     *
     * @param language "en" or "ru"
     */
    public JsonNode exercise(String token, String id, String language)
            throws IOException, InterruptedException {
        return tree(get("/api/v1/exercises/" + id + "?lang=" + language, token));
    }

    /**
     * A submission with what is known of its result.
     *
     * @param language "en" or "ru"
     */
    public JsonNode submission(String token, String id, String language)
            throws IOException, InterruptedException {
        return tree(get("/api/v1/submissions/" + id + "?lang=" + language, token));
    }

    /**
     * Asks for something to be done that needs no more words.
     *
     * @param key makes repeating the call do it once
     */
    public byte[] post(String path, String token, String key)
            throws IOException, InterruptedException {
        return answered(
                request(path, token)
                        .header("Idempotency-Key", key)
                        .POST(BodyPublishers.noBody())
                        .build());
    }

    public byte[] get(String path, String token) throws IOException, InterruptedException {
        return answered(request(path, token).GET().build());
    }

    /** The events of a submission from its beginning; to be closed. */
    EventLines events(String token, String id) {
        HttpRequest request =
                HttpRequest.newBuilder(URI.create(server + "/api/v1/submissions/" + id + "/events"))
                        .header("Authorization", "Bearer " + token)
                        .header("Accept", "text/event-stream")
                        .GET()
                        .build();
        return EventLines.open(http, request, patience.quiet());
    }

    public JsonNode tree(byte[] body) throws IOException {
        try {
            return OwnJson.MAPPER.readTree(body);
        } catch (JsonProcessingException e) {
            throw new IOException(server + " answers something that is no JSON", e);
        }
    }

    private HttpRequest.Builder request(String path) {
        return HttpRequest.newBuilder(URI.create(server + path)).timeout(patience.answering());
    }

    private HttpRequest.Builder request(String path, String token) {
        return request(path).header("Authorization", "Bearer " + token);
    }

    private byte[] answered(HttpRequest request) throws IOException, InterruptedException {
        HttpResponse<byte[]> response = http.send(request, BodyHandlers.ofByteArray());
        if (response.statusCode() / 100 == 2) return response.body();
        throw refusal(response.statusCode(), response.body());
    }

    /** The refusal in the server's words; where it has none, with what the answer is. */
    private ServerRefusal refusal(int status, byte[] body) {
        try {
            JsonNode problem = OwnJson.MAPPER.readTree(body);
            String type = problem.path("type").asText();
            String code = type.startsWith(PROBLEM) ? type.substring(PROBLEM.length()) : "";
            String detail = problem.path("detail").asText();
            return new ServerRefusal(status, code, detail.isEmpty() ? "status " + status : detail);
        } catch (IOException noJson) {
            return new ServerRefusal(
                    status, "", "status " + status + ", not from a grading server");
        }
    }
}
