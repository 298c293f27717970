package rasterlab.app.tour;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.app.language.Texts;
import rasterlab.exercises.published.ShownWords;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PicturePart;
import rasterlab.exercises.score.PixelRows;
import rasterlab.exercises.score.PublishedVerdict;

/** A real server, a course, a student and four submissions. */
final class GradingSection implements TourPart {
    private static final String EXERCISE = "line-bresenham";

    private static final List<Solution> SOLUTIONS =
            List.of(
                    new Solution("right", "ok"),
                    new Solution("wrong", "wrong"),
                    new Solution("forbidden", "refused"),
                    new Solution("endless", "time_limit"));

    /**
     * A source of that name beside this class.
     *
     * @param verdict what the server has to say to it
     */
    private record Solution(String name, String verdict) {}

    private final Optional<Path> home;

    /**
     * @param home the folder of the {@code ./lab} script; none if unknown
     */
    GradingSection(Optional<Path> home) {
        this.home = home;
    }

    @Override
    public String key() {
        return "grading";
    }

    @Override
    public void make(TourPage page) throws Exception {
        Path script =
                home.orElseThrow(
                        () -> new IllegalStateException(page.texts().text("grading.home")));
        page.say(page.texts().text("grading.starting"));
        try (var server = GraderProcess.start(script, line -> page.say("  server: " + line))) {
            var client = new GraderClient(server.address());
            String code = client.createCourse(server.token(), "Tour");
            String student = client.join(code, "Ada");
            submitAll(page, client, student);
        }
    }

    private static void submitAll(TourPage page, GraderClient client, String student)
            throws IOException, InterruptedException {
        List<GradedSolution> all = new ArrayList<>();
        for (Solution solution : SOLUTIONS) {
            page.say(page.texts().text("grading.submitting", solution.name));
            long start = System.nanoTime();
            String language = page.texts().locale().getLanguage();
            JsonNode result = client.graded(student, EXERCISE, source(solution.name), language);
            all.add(new GradedSolution(solution.name, result, (System.nanoTime() - start) / 1e9));
        }
        page.table(
                page.texts().text("grading.heads"),
                all.stream().map(graded -> graded.row(page.texts())).toList());
        page.paragraph(
                page.texts()
                        .text("grading.isolation", all.get(0).result.path("isolation").asText()));
        for (GradedSolution graded : all) show(page, client, student, graded);
        for (int i = 0; i < all.size(); i++) requireVerdict(page, SOLUTIONS.get(i), all.get(i));
    }

    private static void requireVerdict(TourPage page, Solution solution, GradedSolution graded) {
        String verdict = graded.result.path("verdict").asText();
        if (!verdict.equals(solution.verdict))
            throw new IllegalStateException(
                    page.texts()
                            .text(
                                    "grading.unexpected",
                                    solution.name,
                                    called(verdict, page.texts()),
                                    called(solution.verdict, page.texts())));
    }

    private static String called(String verdict, Texts texts) {
        return GradingVerdict.word(verdict, texts.locale().getLanguage());
    }

    /** The answer of the server to one solution. */
    record GradedSolution(String solution, JsonNode result, double seconds) {
        List<String> row(Texts texts) {
            JsonNode points = result.path("points");
            return List.of(
                    texts.text("grading." + solution),
                    called(result.path("verdict").asText(), texts),
                    points.path("total").asInt() + "/" + points.path("of").asInt(),
                    points.path("accuracy").asText(),
                    points.path("stability").asText(),
                    points.path("speed").asText(),
                    String.format(texts.locale(), "%.1f", seconds));
        }
    }

    private static void show(
            TourPage page, GraderClient client, String student, GradedSolution graded)
            throws IOException, InterruptedException {
        page.heading(page.texts().text("grading." + graded.solution));
        page.preformatted(source(graded.solution));
        for (JsonNode diagnostic : graded.result.path("diagnostics"))
            page.paragraph(
                    page.texts()
                            .text(
                                    "grading.diagnostic",
                                    diagnostic.path("line").asText(),
                                    diagnostic.path("message").asText()));
        List<List<String>> rows = new ArrayList<>();
        for (JsonNode judged : graded.result.path("cases"))
            rows.add(
                    List.of(
                            title(judged),
                            called(verdict(judged), page.texts()),
                            judged.path("points").asText() + "/" + judged.path("of").asText(),
                            ShownWords.of(judged.path("message").asText())));
        if (!rows.isEmpty()) page.table(page.texts().text("grading.cases"), rows);
        showFirstPicture(page, path -> client.get(path, student), graded);
    }

    /** Shows the first case that has pictures: the difference as text, and all of them. */
    static void showFirstPicture(TourPage page, PngSource pngs, GradedSolution graded)
            throws IOException, InterruptedException {
        for (JsonNode judged : graded.result.path("cases")) {
            JsonNode pictures = judged.path("pictures");
            if (pictures.isEmpty()) continue;
            page.paragraph(page.texts().text("grading.picture", title(judged)));
            List<TourPage.CaptionedPicture> figures = new ArrayList<>();
            for (JsonNode one : pictures) {
                String kind = one.path("kind").asText();
                if (kind.equals(CasePicture.DIFFERENCE)) showText(page, one);
                String name = judged.path("name").asText() + "-" + kind;
                figures.add(
                        page.picture(
                                "graded-" + graded.solution + "-" + name,
                                pngs.get(one.path("url").asText()),
                                named(kind, page.texts())));
            }
            page.smallGallery(figures);
            return;
        }
    }

    private static void showText(TourPage page, JsonNode difference) {
        var part = PicturePart.ofData(difference.path("part").toString());
        part.filter(known -> !known.isWhole())
                .map(known -> known.message().in(page.texts().locale().getLanguage()))
                .ifPresent(page::paragraph);
        String text = difference.path("text").asText();
        List<String> rows = PixelRows.of(text, part);
        page.preformatted(rows.isEmpty() ? text : String.join("\n", rows));
    }

    /** A kind of picture that is not known under its own name. */
    private static String named(String kind, Texts texts) {
        String key = "grading.picture." + kind;
        return texts.has(key) ? texts.text(key) : kind;
    }

    /** The text that the server has at an address. */
    interface PngSource {
        byte[] get(String path) throws IOException, InterruptedException;
    }

    private static String verdict(JsonNode judged) {
        return new PublishedVerdict(
                        judged.path("verdict").asText(), judged.path("run").asBoolean(true))
                .codeFor(judged.path("points").asInt(), judged.path("of").asInt());
    }

    private static String title(JsonNode judged) {
        return judged.path("title").asText();
    }

    /** The solution of that name. */
    static String source(String solution) {
        String name = "solution-" + solution + ".java.txt";
        try (InputStream in = GradingSection.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(name + " cannot be read", e);
        }
    }
}
