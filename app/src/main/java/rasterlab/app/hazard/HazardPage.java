package rasterlab.app.hazard;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import javax.imageio.ImageIO;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Guard;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.MethodAnswer;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.graded.AnswerPictures;
import rasterlab.exercises.score.PictureBytes;

/** The page of one topic: every method on every hazard. */
public final class HazardPage<C, I, O> {
    private static final Duration LONGEST_DRAWING = Duration.ofSeconds(10);

    /** How many times wider than high a picture is that scrolls. */
    private static final int FLAT = 4;

    private final Topic<C, I, O> topic;
    private final BooleanSupplier cancelled;
    private final Texts texts;
    private final TopicNames called;
    private final StudyWords words;
    private final AnswerPictures<C, I, O> pictures;
    private final List<VerdictCell> verdicts = new ArrayList<>();
    private final StringBuilder cells = new StringBuilder();

    /** The right answer to the hazard that is being written, once a cell has shown it. */
    private Optional<RightAnswer> right = Optional.empty();

    private HazardPage(Topic<C, I, O> topic, Language language, BooleanSupplier cancelled) {
        this.topic = topic;
        this.cancelled = cancelled;
        texts = Texts.of("hazard", language);
        called = TopicNames.in(language);
        words = new StudyWords(language);
        pictures = new AnswerPictures<>(topic);
    }

    /**
     * A page as a document of its own.
     *
     * @param matrix the verdicts that it tells
     */
    public record HazardDocument(String html, HazardMatrix matrix) {}

    /**
     * Tries every method on every hazard of the topic and writes what came of it.
     *
     * @param longest wall time that a method may take for one hazard
     */
    public static HazardDocument of(Topic<?, ?, ?> topic, Duration longest, Language language) {
        return of(topic, longest, language, () -> false);
    }

    /**
     * Tries every method on every hazard of the topic and writes what came of it.
     *
     * @param longest wall time that a method may take for one hazard
     * @param cancelled asked before each right answer and each verdict
     * @throws CancellationException when {@code cancelled} says so
     */
    public static HazardDocument of(
            Topic<?, ?, ?> topic, Duration longest, Language language, BooleanSupplier cancelled) {
        return written(topic, longest, language, cancelled);
    }

    private static <C, I, O> HazardDocument written(
            Topic<C, I, O> topic, Duration longest, Language language, BooleanSupplier cancelled) {
        var page = new HazardPage<>(topic, language, cancelled);
        topic.hazards().forEach(hazard -> page.add(hazard, longest));
        HazardMatrix matrix = HazardMatrix.of(topic, page.verdicts);
        return new HazardDocument(page.html(matrix), matrix);
    }

    private String html(HazardMatrix matrix) {
        var body = new StringBuilder();
        String name = texts.text("title", called.topic(topic.name()), topic.name());
        body.append("<h1>%s</h1>\n<p>%s</p>\n".formatted(text(name), text(texts.text("about"))));
        body.append(CommandHtml.of(texts.language().command("hazards " + topic.name())));
        body.append("<h2>%s</h2>\n<dl>\n".formatted(text(texts.text("rules"))));
        for (Verdict.Kind kind : Verdict.Kind.values())
            body.append(
                    "<dt class=\"%s\">%s</dt><dd>%s</dd>\n"
                            .formatted(
                                    kind.code(),
                                    text(VerdictTable.signed(kind, words)),
                                    text(texts.text("rule." + kind.code()))));
        body.append("</dl>\n<h2>%s</h2>\n".formatted(text(texts.text("table"))));
        body.append(VerdictTable.of(topic, matrix, texts.language(), ""));
        return HazardHtml.document(name, texts.language(), body.append(cells).toString());
    }

    private void requireGoing() {
        if (cancelled.getAsBoolean())
            throw new CancellationException("hazards of '" + topic.name() + "' were cancelled");
    }

    private void add(Hazard<I> hazard, Duration longest) {
        requireGoing();
        Function<Method<C>, MethodAnswer<O>> trial =
                HazardTrial.trying(topic, hazard.input(), longest);
        String title = called.hazard(topic, hazard);
        var below = new StringBuilder();
        right = Optional.empty();
        for (Method<C> method : topic.methods()) {
            requireGoing();
            MethodAnswer<O> tried = trial.apply(method);
            Verdict.Kind recorded =
                    hazard.recorded().getOrDefault(method.name(), Verdict.Kind.EXACT);
            var cell = new VerdictCell(hazard.name(), method.name(), tried.verdict(), recorded);
            verdicts.add(cell);
            below.append(section(hazard, method, tried, cell.asRecorded()));
        }
        cells.append("<h2 id=\"%s\">%s</h2>\n".formatted(hazard.name(), text(title)));
        cells.append("<p>%s</p>\n".formatted(text(explanation(hazard))));
        cells.append("<div class=\"cells\">\n").append(below).append("</div>\n");
    }

    private String explanation(Hazard<I> hazard) {
        return TopicTexts.of(topic.name(), texts.language()).hazard(hazard);
    }

    private String section(
            Hazard<I> hazard, Method<C> method, MethodAnswer<O> tried, boolean known) {
        Verdict verdict = tried.verdict();
        var html =
                new StringBuilder(
                        "<section id=\"%s\"><h3 class=\"%s\">%s: %s</h3>\n"
                                .formatted(
                                        VerdictTable.id(hazard.name(), method.name()),
                                        verdict.kind().code(),
                                        text(method.name()),
                                        text(
                                                VerdictTable.signed(verdict.kind(), words)
                                                        + (known ? "" : " !"))));
        String detail = VerdictDetail.saidToTypist(texts.language(), verdict.detail());
        if (!verdict.detail().isEmpty()) html.append("<p>%s</p>\n".formatted(text(detail)));
        html.append(picture(hazard, tried));
        return html.append(CommandHtml.of(repeating(hazard, method.name())))
                .append("</section>\n")
                .toString();
    }

    /**
     * The picture of a method's answer to the hazard: what differs, or, where nothing does, the
     * right answer.
     */
    private String picture(Hazard<I> hazard, MethodAnswer<O> tried) {
        if (tried.made().isEmpty()) return "";
        if (tried.verdict().kind() == Verdict.Kind.EXACT) return rightPicture(hazard, tried);
        return guarded(
                        hazard,
                        () -> pictures.drawn(hazard.input(), tried.exact(), tried.made().get()))
                .map(
                        drawn ->
                                framed(
                                        "<img alt=\"%s\" src=\"%s\">\n"
                                                .formatted(
                                                        text(texts.text("difference")),
                                                        data(drawn)),
                                        size(drawn)))
                .orElseGet(() -> notDrawn());
    }

    /** The right answer's picture, which the page holds once for all cells that show it. */
    private String rightPicture(Hazard<I> hazard, MethodAnswer<O> tried) {
        String id = "right." + hazard.name();
        if (right.isEmpty())
            right =
                    guarded(hazard, () -> pictures.right(hazard.input(), tried.exact()))
                            .map(drawn -> new RightAnswer(data(drawn), size(drawn)))
                            .or(() -> Optional.of(RightAnswer.NONE));
        RightAnswer shown = right.orElseThrow();
        return framed(shown.html(id, text(texts.text("right")), notDrawn()), shown.size());
    }

    /** A picture; one of a single row scrolls, as its numbers could not be read made smaller. */
    private static String framed(String picture, Dimension size) {
        boolean flat = size.width >= FLAT * size.height && size.height > 0;
        return flat ? "<div class=\"scroll flat\">" + picture + "</div>\n" : picture;
    }

    private String notDrawn() {
        return "<p>%s</p>\n".formatted(text(texts.text("not.drawn")));
    }

    private String data(PictureBytes drawn) {
        byte[] png = drawn.in(texts.locale().getLanguage());
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(png);
    }

    private Dimension size(PictureBytes drawn) {
        try {
            byte[] png = drawn.in(texts.locale().getLanguage());
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
            return new Dimension(image.getWidth(), image.getHeight());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Draws under guard, since an answer may be huge. */
    private static Optional<PictureBytes> guarded(
            Hazard<?> hazard, Callable<Optional<PictureBytes>> drawing) {
        var drawn = Guard.call("picture of " + hazard.name(), drawing, LONGEST_DRAWING);
        return drawn instanceof Guard.Returned<Optional<PictureBytes>> returned
                ? returned.value()
                : Optional.empty();
    }

    private String repeating(Hazard<I> hazard, String method) {
        return VerdictTable.repeating(topic.name(), method, hazard.name(), texts.language());
    }

    private static String text(String said) {
        return HazardHtml.escaped(said);
    }

    /** A page that leads to those of the topics. */
    public static String contents(List<Topic<?, ?, ?>> topics, Language language) {
        Texts texts = Texts.of("hazard", language);
        var body = new StringBuilder("<h1>" + text(texts.text("all")) + "</h1>\n<ul>\n");
        for (Topic<?, ?, ?> topic : topics)
            body.append(
                    "<li><a href=\"%s.html\">%s</a></li>\n"
                            .formatted(
                                    topic.name(),
                                    text(TopicNames.in(language).topic(topic.name()))));
        return HazardHtml.document(texts.text("all"), language, body.append("</ul>\n").toString());
    }
}
