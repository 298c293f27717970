package rasterlab.app.exercise;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.ResultPicture;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.Following;
import rasterlab.app.server.ServerReport;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.published.PublishedCase;
import rasterlab.exercises.published.PublishedDiagnostic;
import rasterlab.exercises.published.PublishedPicture;
import rasterlab.exercises.published.PublishedPoints;
import rasterlab.exercises.published.PublishedReport;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PictureBytes;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

/** Hands a source in and follows it to its result. */
final class Submitting {
    /** Hears how a submission gets on, on the thread that follows it. */
    interface SubmissionListener {
        /**
         * @param position in the queue, 1 being the next, 0 when its turn has come
         */
        void waits(int position);

        /**
         * @param cases those judged so far
         */
        void judged(List<CaseResult> cases);
    }

    private final CourseServer server;
    private final String token;
    private final TaskKind form;
    private final boolean late;

    /** Hands in Java sources. */
    Submitting(CourseServer server, String token) {
        this(server, token, TaskKind.WRITE);
    }

    Submitting(CourseServer server, String token, TaskKind form) {
        this(server, token, form, false);
    }

    private Submitting(CourseServer server, String token, TaskKind form, boolean late) {
        this.server = server;
        this.token = token;
        this.form = form;
        this.late = late;
    }

    /**
     * This submission where the student agrees, or not, that a late submission is marked as such.
     */
    Submitting late(boolean agreed) {
        return new Submitting(server, token, form, agreed);
    }

    /** Hands in what an exercise of that form is answered by, on the account. */
    static Submitting to(Account account, CourseServer.ServerTimeouts patience, TaskKind form) {
        return new Submitting(new CourseServer(account.server(), patience), account.token(), form);
    }

    /**
     * Submits and waits for the result. Asked again with the same key, it goes on following the
     * same submission.
     */
    Outcome result(String exercise, String source, String key, SubmissionListener follower)
            throws IOException, InterruptedException {
        String id = server.submit(token, exercise, form.mediaType(), source, key, late);
        new Following(server, token).toItsEnd(id, inCases(follower));
        return outcome(source, id);
    }

    private static Following.Follower inCases(SubmissionListener follower) {
        List<CaseResult> judged = new ArrayList<>();
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
                judged.add(tried(ServerReport.judged(one), LocalizedText.NOTHING, List.of()));
                follower.judged(List.copyOf(judged));
            }
        };
    }

    private Outcome outcome(String source, String id) throws IOException, InterruptedException {
        JsonNode submission = server.submission(token, id, "en");
        PublishedReport english = ServerReport.read(submission);
        PublishedReport russian = ServerReport.read(server.submission(token, id, "ru"));
        List<CaseResult> cases = new ArrayList<>();
        for (PublishedCase one : english.cases()) {
            // Cases are matched by place, not by name: several may be called hidden.
            Optional<PublishedCase> other = at(russian.cases(), cases.size());
            LocalizedText said =
                    new LocalizedText(one.message(), other.map(PublishedCase::message).orElse(""));
            cases.add(
                    tried(one, withReason(said, one, other), pictures(one, other))
                            .under(rule(one, other)));
        }
        return new Outcome(
                source,
                submission.path("attempt").asInt(),
                english.verdict(),
                points(english.points()),
                cases,
                remarks(english.diagnostics(), russian.diagnostics()),
                LocalizedText.of(code -> Report.isolationIn(code, english.isolation())),
                0,
                !submission.path("current").asBoolean(true),
                english.points().hints(),
                english.speed());
    }

    /** Adds, below what is said, why a hidden case is there, once the server tells it. */
    private static LocalizedText withReason(
            LocalizedText said, PublishedCase english, Optional<PublishedCase> russian) {
        if (english.why().isEmpty()) return said;
        LocalizedText reason =
                new LocalizedText(
                        because(Language.ENGLISH, english.why()),
                        because(Language.RUSSIAN, russian.flatMap(PublishedCase::why)));
        return said.equals(LocalizedText.NOTHING) ? reason : said.above(reason);
    }

    private static LocalizedText rule(PublishedCase english, Optional<PublishedCase> russian) {
        return new LocalizedText(
                rule(Language.ENGLISH, Optional.of(english)), rule(Language.RUSSIAN, russian));
    }

    private static String rule(Language language, Optional<PublishedCase> one) {
        return CaseResult.rule(
                language,
                one.flatMap(PublishedCase::tolerance).orElse(""),
                one.flatMap(PublishedCase::rule).orElse(""));
    }

    private static String because(Language language, Optional<String> why) {
        return Texts.of("exercise", language).text("why", why.orElse(""));
    }

    private static <T> Optional<T> at(List<T> all, int index) {
        return index < all.size() ? Optional.of(all.get(index)) : Optional.empty();
    }

    private static ScorePoints points(PublishedPoints points) throws IOException {
        try {
            return new ScorePoints(
                    points.accuracy(), points.stability(), points.speed(), points.of());
        } catch (IllegalArgumentException e) {
            throw new IOException("the server's points do not fit: " + e.getMessage(), e);
        }
    }

    private static CaseResult tried(
            PublishedCase one, LocalizedText said, List<ResultPicture> pictures) {
        return new CaseResult(
                one.name(),
                one.verdict().codeFor(one.points(), one.of()),
                one.points(),
                one.of(),
                said,
                pictures,
                one.scene());
    }

    private List<ResultPicture> pictures(PublishedCase english, Optional<PublishedCase> russian)
            throws IOException, InterruptedException {
        List<PublishedPicture> others = russian.map(PublishedCase::pictures).orElse(List.of());
        var pictures = new ArrayList<ResultPicture>();
        for (PublishedPicture one : english.pictures()) {
            if (!CasePicture.isKind(one.kind()))
                throw new IOException("the server's kind of a picture is '" + one.kind() + "'");
            Optional<PublishedPicture> other = at(others, pictures.size());
            pictures.add(
                    new ResultPicture(
                            one.kind(),
                            file(one.url(), other.map(PublishedPicture::url).orElse(one.url())),
                            new LocalizedText(
                                    one.text(), other.map(PublishedPicture::text).orElse("")),
                            one.part()));
        }
        return pictures;
    }

    /** The picture, in Russian another one where the server names another address. */
    private PictureBytes file(String english, String russian)
            throws IOException, InterruptedException {
        byte[] usual = png(english);
        if (russian.equals(english)) return PictureBytes.alike(usual);
        byte[] own = png(russian);
        return PictureBytes.of(usual, Map.of("ru", () -> own));
    }

    private byte[] png(String path) throws IOException, InterruptedException {
        if (!path.startsWith("/api/v1/"))
            throw new IOException("the server's address of a picture is '" + path + "'");
        return server.get(path, token);
    }

    private static List<Outcome.Remark> remarks(
            List<PublishedDiagnostic> english, List<PublishedDiagnostic> russian) {
        List<Outcome.Remark> remarks = new ArrayList<>();
        for (PublishedDiagnostic one : english) {
            PublishedDiagnostic other = at(russian, remarks.size()).orElse(one);
            remarks.add(
                    new Outcome.Remark(
                            one.line(),
                            one.column(),
                            new LocalizedText(one.message(), other.message())));
        }
        return remarks;
    }
}
