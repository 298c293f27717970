package rasterlab.app.findings;

import java.awt.Color;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.findings.FoundContents.TopicFinding;
import rasterlab.app.hazard.HazardPage;
import rasterlab.app.hazard.VerdictTable;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.study.StudyCost;
import rasterlab.app.study.StudyFile;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.app.study.front.StudyPlot;
import rasterlab.engine.Topics;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.Machine;

/** Measures topics and writes what was found: a folder of pages, charts and numbers. */
public final class Findings {
    private static final ChartLook DARK =
            new ChartLook(new Color(0x16, 0x19, 0x1f), new Color(0xe6, 0xe9, 0xee));

    static final String CHARTS = "charts";
    private static final String DATA = "data";
    private static final String HAZARDS = "hazards";

    private static final Verdict.Kind DEGRADED = Verdict.Kind.DEGRADED;

    /** The charts of a page, in their order. */
    private static final List<StudyPlot> SHOWN =
            List.of(
                    StudyPlot.FRONT,
                    StudyPlot.ERROR_BY_INPUT,
                    StudyPlot.SIZES,
                    StudyPlot.COST_GROWTH,
                    StudyPlot.ERROR_GROWTH);

    private final Path folder;
    private final StudySettings settings;
    private final String pace;
    private final Language language;
    private final Texts texts;
    private final TopicNames called;
    private final Consumer<String> progress;
    private final BooleanSupplier stopped;

    /**
     * @param folder where everything goes; files of other names are left alone
     * @param pace the options of {@code ./lab study} that stand for the settings but the seed, each
     *     behind a space; may be empty
     * @param progress told about each topic in one line
     * @param stopped asked before each piece of work; what was found till then is written
     */
    public Findings(
            Path folder,
            StudySettings settings,
            String pace,
            Language language,
            Consumer<String> progress,
            BooleanSupplier stopped) {
        this.folder = folder;
        this.settings = settings;
        this.pace = pace;
        this.language = language;
        this.progress = progress;
        this.stopped = stopped;
        texts = Texts.of("findings", language);
        called = TopicNames.in(language);
    }

    /**
     * Writes the pages.
     *
     * @return whether every topic was measured to its end
     * @throws rasterlab.app.outcome.Complaint if the folder cannot be written to
     */
    public boolean write(List<? extends Topic<?, ?, ?>> topics) {
        WholeFile.requireFolder(folder.resolve(CHARTS));
        WholeFile.requireFolder(folder.resolve(DATA));
        WholeFile.requireFolder(folder.resolve(HAZARDS));
        WholeFile.requireWritable(index());
        Map<Topic<?, ?, ?>, TopicFinding> found = new LinkedHashMap<>();
        for (Topic<?, ?, ?> topic : topics) {
            if (!stopped.getAsBoolean()) progress.accept(texts.text("measuring", topic.name()));
            found.put(topic, found(topic));
        }
        new FoundContents(folder, shared(), texts, called)
                .write(found, language.command("study --all" + paced() + " --out findings"));
        return found.values().stream().allMatch(TopicFinding::whole);
    }

    /** The page of contents. */
    public Path index() {
        return FoundContents.index(folder);
    }

    /** The settings, language and machine that pages beside each other have in common. */
    private String shared() {
        return settings + ", " + language + ", " + Machine.here().described();
    }

    /** The options that repeat these settings. */
    private String paced() {
        return pace + " --seed " + settings.seed();
    }

    private TopicFinding found(Topic<?, ?, ?> topic) {
        if (stopped.getAsBoolean()) return TopicFinding.none(texts.text("notMeasured"));
        try {
            Study study = StudyRunner.measure(topic, settings, step -> {}, stopped);
            if (!study.isTimed()) return TopicFinding.none(texts.text("notMeasured"));
            writeData(study);
            HazardMatrix hazards = judged(topic);
            var words = new FoundWords(topic, study, hazards, language);
            writeTopic(topic, study, hazards, words);
            String first = words.sentences().get(0);
            return study.isWhole()
                    ? new TopicFinding(true, true, first)
                    : new TopicFinding(false, true, first + " " + texts.text("cut"));
        } catch (CancellationException stop) {
            return TopicFinding.none(texts.text("cut"));
        } catch (RuntimeException | LinkageError e) {
            String reason = e.getMessage() == null ? e.toString() : e.getMessage();
            return TopicFinding.none(texts.text("failed", Complaints.translated(language, reason)));
        }
    }

    /** Tries the hazards, and writes the page with each verdict's picture and command. */
    private HazardMatrix judged(Topic<?, ?, ?> topic) {
        HazardPage.HazardDocument page =
                HazardPage.of(topic, HazardTrial.WALL_LIMIT, language, stopped);
        WholeFile.write(
                folder.resolve(hazardPage(topic)), page.html().getBytes(StandardCharsets.UTF_8));
        return page.matrix();
    }

    private static String hazardPage(Topic<?, ?, ?> topic) {
        return HAZARDS + "/" + topic.name() + ".html";
    }

    private void writeData(Study study) {
        for (String extension : List.of(".json", ".csv"))
            StudyFile.write(
                    study, folder.resolve(DATA).resolve(study.topic() + extension), language);
        for (StudyPlot plot : StudyPlot.values())
            writeChart(study, plot, StudyCost.TIME, study.topic() + "-" + plot.code());
        for (StudyCost cost : counted(Topics.named(study.topic())))
            writeChart(study, StudyPlot.FRONT, cost, front(study.topic(), cost));
    }

    private void writeChart(Study study, StudyPlot plot, StudyCost cost, String name) {
        Path charts = folder.resolve(CHARTS);
        Study shown = cost.of(study);
        StudyWords words = cost.words(language);
        WholeFile.write(
                charts.resolve(name + ".svg"),
                plot.of(shown, words, ChartLook.PAPER).svg(ChartLook.PAPER));
        WholeFile.write(charts.resolve(name + "-dark.svg"), plot.of(shown, words, DARK).svg(DARK));
    }

    /** The costs beside time that a topic has, each a front of its own. */
    private static List<StudyCost> counted(Topic<?, ?, ?> topic) {
        return Stream.of(StudyCost.OPERATIONS, StudyCost.PARTS)
                .filter(cost -> cost.isPossible(topic))
                .toList();
    }

    private static String front(String topic, StudyCost cost) {
        return topic + "-" + StudyPlot.FRONT.code() + "-" + cost.code();
    }

    private void writeTopic(
            Topic<?, ?, ?> topic, Study study, HazardMatrix hazards, FoundWords words) {
        StudyConditions how = study.circumstances().orElseThrow();
        var origin = new PageOrigin(shared(), begun(how));
        var page = new FoundPage(FoundWords.capital(called.topic(topic.name())), texts, origin);
        page.link("index.html", texts.text("contents"), "");
        words.sentences().forEach(page::paragraph);
        if (!study.isWhole()) page.warning(texts.text("cut"));
        for (StudyPlot plot : SHOWN) {
            String name = CHARTS + "/" + topic.name() + "-" + plot.code();
            page.begin("shown");
            page.chart(name, texts.text("chart." + plot.code()), name + ".svg");
            page.command(
                    language.command(
                            "study %s%s --chart %s --out %s.svg"
                                    .formatted(topic.name(), paced(), plot.code(), plot.code())));
            page.end();
            if (plot == StudyPlot.FRONT) addCounted(page, topic);
        }
        page.heading(texts.text("hazards")).paragraph(texts.text("hazards.meaning"));
        if (hazards.cells().stream().anyMatch(cell -> cell.verdict().kind() == DEGRADED))
            page.paragraph(VerdictTable.rule(DEGRADED, language));
        page.verdicts(VerdictTable.of(topic, hazards, language, hazardPage(topic)));
        page.command(language.command("hazards " + topic.name()));
        page.heading(texts.text("how")).paragraph(words.measured(how));
        page.link(DATA + "/" + topic.name() + ".json", "JSON", texts.text("data.json"));
        page.link(DATA + "/" + topic.name() + ".csv", "CSV", texts.text("data.csv"));
        WholeFile.write(FoundContents.page(folder, topic), page.html());
    }

    private void addCounted(FoundPage page, Topic<?, ?, ?> topic) {
        for (StudyCost cost : counted(topic)) {
            String name = CHARTS + "/" + front(topic.name(), cost);
            page.begin("shown");
            page.chart(name, texts.text("chart." + cost.code()), name + ".svg");
            page.command(
                    language.command(
                            "study %s%s --cost %s --out %s.svg"
                                    .formatted(topic.name(), paced(), cost.code(), cost.code())));
            page.end();
        }
    }

    /** When a study was begun, as people read it. */
    static String begun(StudyConditions how) {
        return DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm")
                .format(how.begun().atZone(ZoneOffset.UTC));
    }
}
