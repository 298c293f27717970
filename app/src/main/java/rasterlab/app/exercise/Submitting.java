package rasterlab.app.exercise;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.Following;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PicturePart;
import rasterlab.exercises.score.Points;
import rasterlab.exercises.score.PublishedVerdict;
import rasterlab.exercises.score.Report;

/** Hands a source in and follows it to its result. */
final class Submitting {
    /** Told how a submission gets on, on the thread that follows it. */
    interface Follower {
        /**
         * @param position in the queue, 1 being the next, 0 when its turn has come
         */
        void waits(int position);

        /**
         * @param cases those judged so far
         */
        void judged(List<TriedCase> cases);
    }

    private final CourseServer server;
    private final String token;
    private final Form form;

    /** Hands in Java sources. */
    Submitting(CourseServer server, String token) {
        this(server, token, Form.WRITE);
    }

    Submitting(CourseServer server, String token, Form form) {
        this.server = server;
        this.token = token;
        this.form = form;
    }

    /**
     * Submits and waits for the result. Asked again with the same key, it goes on following the
     * same submission.
     */
    Outcome result(String exercise, String source, String key, Follower follower)
            throws IOException, InterruptedException {
        String id = server.submit(token, exercise, form.mediaType(), source, key);
        new Following(server, token).toItsEnd(id, inCases(follower));
        return outcome(source, id);
    }

    private static Following.Follower inCases(Follower follower) {
        List<TriedCase> judged = new ArrayList<>();
        return new Following.Follower() {
            @Override
            public void begins() {
                judged.clear();
            }

            @Override
            public void waits(int position) {
                follower.waits(position);
            }

            @Override
            public void judged(JsonNode one) {
                judged.add(tried(one, Said.NOTHING, List.of()));
                follower.judged(List.copyOf(judged));
            }
        };
    }

    private Outcome outcome(String source, String id) throws IOException, InterruptedException {
        JsonNode english = server.submission(token, id, "en");
        JsonNode russian = server.submission(token, id, "ru");
        List<TriedCase> cases = new ArrayList<>();
        for (int i = 0; i < english.path("cases").size(); i++) {
            JsonNode one = english.path("cases").get(i);
            // Not by its name: several may be called hidden.
            JsonNode other = russian.path("cases").path(i);
            cases.add(tried(one, said(one, other), pictures(one, other)));
        }
        return new Outcome(
                source,
                english.path("attempt").asInt(),
                english.path("verdict").asText(),
                points(english.path("points")),
                cases,
                remarks(english.path("diagnostics"), russian.path("diagnostics")),
                Said.of(code -> isolation(english, code)),
                0,
                !english.path("current").asBoolean(true));
    }

    private static String isolation(JsonNode view, String language) {
        return Report.isolationIn(language, view.path("isolation").asText(""));
    }

    private static Said said(JsonNode english, JsonNode russian) {
        return new Said(english.path("message").asText(), russian.path("message").asText());
    }

    private static Points points(JsonNode points) throws IOException {
        try {
            return new Points(
                    points.path("accuracy").asInt(),
                    points.path("stability").asInt(),
                    points.path("speed").asInt(),
                    points.path("of").asInt());
        } catch (IllegalArgumentException e) {
            throw new IOException("the server's points do not fit: " + e.getMessage(), e);
        }
    }

    private static TriedCase tried(JsonNode one, Said said, List<TriedPicture> pictures) {
        JsonNode scene = one.path("scene");
        var verdict =
                new PublishedVerdict(
                        one.path("verdict").asText(GradingVerdict.NO_RESULT.code()),
                        one.path("run").asBoolean(true));
        int points = one.path("points").asInt();
        int of = one.path("of").asInt();
        return new TriedCase(
                one.path("name").asText(),
                verdict.told(points, of),
                points,
                of,
                said,
                pictures,
                scene.isObject() ? scene.toString() : "");
    }

    private List<TriedPicture> pictures(JsonNode english, JsonNode russian)
            throws IOException, InterruptedException {
        var pictures = new ArrayList<TriedPicture>();
        for (JsonNode one : english.path("pictures")) {
            String kind = one.path("kind").asText();
            if (!CasePicture.isKind(kind))
                throw new IOException("the server's kind of a picture is '" + kind + "'");
            JsonNode other = russian.path("pictures").path(pictures.size());
            pictures.add(
                    new TriedPicture(
                            kind,
                            png(one.path("url").asText()),
                            new Said(one.path("text").asText(), other.path("text").asText()),
                            PicturePart.ofData(one.path("part").toString())));
        }
        return pictures;
    }

    private byte[] png(String path) throws IOException, InterruptedException {
        if (!path.startsWith("/api/v1/"))
            throw new IOException("the server's address of a picture is '" + path + "'");
        return server.get(path, token);
    }

    private static List<Outcome.Remark> remarks(JsonNode english, JsonNode russian) {
        List<Outcome.Remark> remarks = new ArrayList<>();
        for (int i = 0; i < english.size(); i++) {
            JsonNode one = english.get(i);
            JsonNode other = i < russian.size() ? russian.get(i) : one;
            remarks.add(
                    new Outcome.Remark(
                            one.path("line").asInt(),
                            one.path("column").asInt(),
                            said(one, other)));
        }
        return remarks;
    }
}
