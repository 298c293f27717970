package rasterlab.app.hazard;

import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/** The table of a topic's verdicts: each has its sign and leads to what its page says of it. */
public final class VerdictTable {
    /** The colour of each verdict, at the left edge of whatever has its class. */
    public static final String COLORS =
            """
            .exact{border-left-color:#009e73}.degraded{border-left-color:#e69f00}
            .wrong,.crashed{border-left-color:#d55e00}.refused{border-left-color:#7f7f7f}
            .endless{border-left-color:#cc79a7}
            """;

    private final Topic<?, ?, ?> topic;
    private final HazardMatrix matrix;
    private final Language language;
    private final TopicNames called;
    private final StudyWords words;
    private final String page;
    private final StringBuilder html = new StringBuilder();

    private VerdictTable(
            Topic<?, ?, ?> topic, HazardMatrix matrix, Language language, String page) {
        this.topic = topic;
        this.matrix = matrix;
        this.page = page;
        this.language = language;
        called = TopicNames.in(language);
        words = new StudyWords(language);
    }

    /**
     * The table as a piece of HTML.
     *
     * @param page the file of the topic's {@link HazardPage}; empty on that page itself
     */
    public static String of(
            Topic<?, ?, ?> topic, HazardMatrix matrix, Language language, String page) {
        return new VerdictTable(topic, matrix, language, page).html();
    }

    /** A verdict's name behind its sign, and what it means. */
    public static String rule(Verdict.Kind kind, Language language) {
        return signed(kind, new StudyWords(language))
                + ": "
                + Texts.of("hazard", language).text("rule." + kind.code());
    }

    static String signed(Verdict.Kind kind, StudyWords words) {
        return HazardHtml.sign(kind) + "\u00a0" + words.verdict(kind);
    }

    /** The command that tries a method on a hazard again. */
    static String repeating(String topic, String method, String hazard, Language language) {
        return language.command("run %s %s --hazard %s".formatted(topic, method, hazard));
    }

    /** The place on the topic's page where that verdict is explained. */
    static String id(String hazard, String method) {
        return hazard + "." + method;
    }

    private String html() {
        html.append("<div class=\"scroll\"><table class=\"verdicts\">\n<thead><tr><th></th>");
        for (String method : matrix.methods())
            html.append("<th>%s</th>".formatted(HazardHtml.escaped(method)));
        html.append("</tr></thead>\n<tbody>\n");
        topic.hazards().forEach(this::addRow);
        return html.append("</tbody></table></div>\n").toString();
    }

    private void addRow(Hazard<?> hazard) {
        html.append(
                "<tr><th><a href=\"%s#%s\">%s</a></th>"
                        .formatted(
                                page,
                                hazard.name(),
                                HazardHtml.escaped(called.hazard(topic, hazard))));
        for (String method : matrix.methods()) addCell(matrix.cell(hazard.name(), method));
        html.append("</tr>\n");
    }

    private void addCell(VerdictCell cell) {
        Verdict.Kind kind = cell.verdict().kind();
        String place = id(cell.hazard(), cell.method());
        String command = repeating(topic.name(), cell.method(), cell.hazard(), language);
        html.append(
                "<td class=\"%s\"><a href=\"%s#%s\" title=\"%s\">%s</a></td>"
                        .formatted(
                                kind.code(),
                                page,
                                place,
                                HazardHtml.escaped(command),
                                HazardHtml.escaped(
                                        signed(kind, words) + (cell.asRecorded() ? "" : " !"))));
    }
}
