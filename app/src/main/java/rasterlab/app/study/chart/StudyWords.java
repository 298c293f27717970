package rasterlab.app.study.chart;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Regime;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

/** The words of a chart or a table of a study, in one language. */
public final class StudyWords {
    private static final String TIMED = "chart.cost";
    private static final String RATIO = "chart.ratio";

    /** The most methods that are named one by one. */
    private static final int MOST_NAMED = 3;

    private final Texts texts;
    private final TopicNames called;
    private final WorkloadWords workloads;

    private final String costKey;

    public StudyWords(Language language) {
        this(language, TIMED);
    }

    private StudyWords(Language language, String costKey) {
        this.costKey = costKey;
        texts = Texts.of("study", language);
        called = TopicNames.in(language);
        workloads = new WorkloadWords(texts);
    }

    /** The words of a chart whose costs were counted, not timed. */
    public static StudyWords ofCounts(Language language) {
        return new StudyWords(language, "chart.counted");
    }

    /** The words of a chart whose costs are the parts that answers are made of. */
    public static StudyWords ofParts(Language language) {
        return new StudyWords(language, "chart.parts");
    }

    /** The words of a chart whose costs are multiples of a reference's time. */
    public static StudyWords ofRatios(Language language) {
        return new StudyWords(language, RATIO);
    }

    /** The locale of numbers with fractions. */
    public Locale locale() {
        return texts.locale();
    }

    /** A method by its name, the user's own program in words. */
    public String called(String method) {
        return OwnWords.called(method, texts.language());
    }

    /**
     * The unit that is counted, as it stands behind "per"; in English where it has no translation.
     */
    public String item(Study study) {
        String plain = texts.textOr(itemKey(study.item()), study.item());
        boolean usual = study.item().equals(Topics.named(study.topic()).item());
        return usual ? own(study).textOr("item", plain) : plain;
    }

    /** Unit of the error; in English where it has no translation. */
    public String errorUnit(Study study) {
        return own(study)
                .textOr("unit", texts.textOr(unitKey(study.errorUnit()), study.errorUnit()));
    }

    private Texts own(Study study) {
        return Texts.ofTopic(study.topic(), texts.language());
    }

    public String verdict(Verdict.Kind kind) {
        return texts.text("verdict." + kind.code());
    }

    /**
     * An error with its unit, which takes the form that goes with the number.
     *
     * @param said the number as it is written
     */
    public String amount(Study study, double error, String said) {
        String key = unitKey(study.errorUnit()).replaceFirst("^unit", "amount");
        return texts.has(key + ".one")
                ? said + " " + texts.plural(key, error)
                : said + " " + errorUnit(study);
    }

    /** The key of a topic's item; keys have hyphens where the engine's words have others. */
    static String itemKey(String item) {
        return "item." + hyphened(item);
    }

    static String unitKey(String unit) {
        return "unit." + hyphened(unit);
    }

    private static String hyphened(String words) {
        return words.replaceAll("[^a-z]+", "-").replaceFirst("^-", "");
    }

    public String title(Study study) {
        return texts.text("chart.title", called.topic(study.topic()));
    }

    public String costAxis(Study study) {
        return texts.text(costKey, item(study));
    }

    /** The axis's words without the one on the sizes beside the points. */
    public String briefCostAxis(Study study) {
        return texts.text(costKey + ".brief", item(study));
    }

    /** A method with its time and its error. */
    public String point(Measurement point) {
        double error = point.error().worst();
        return texts.text(
                "chart.point",
                called(point.method()),
                String.format(locale(), "%.2f", point.cost().medianNanos()),
                error == 0
                        ? exact()
                        : Double.isFinite(error) ? String.format(locale(), "%.3g", error) : "∞");
    }

    public String errorAxis(Study study) {
        return texts.text("chart.error", errorUnit(study));
    }

    /** The sign for errors that count as none. */
    public String exactShort() {
        return texts.text("front.exact");
    }

    /** A number with two digits, as axes have them. */
    public String shortNumber(double value) {
        if (value >= 0.01 && value < 99.5) return String.format(locale(), "%.2g", value);
        return value >= 99.5 && value < 1000
                ? String.format(locale(), "%.0f", value)
                : LogTicks.withPower(value, locale());
    }

    /**
     * @param workload may be empty where there is but one
     */
    public String frontTitle(Study study, String workload) {
        if (workload.isEmpty()) return title(study);
        String key = costKey.equals(RATIO) ? TIMED : costKey;
        return texts.text(
                key.replace("chart.", "front.title."),
                called.topic(study.topic()),
                workload(study.topic(), workload));
    }

    /** How the chart of a front is read, and who could not be timed. */
    public String frontNote(Study study, String workload) {
        Study level =
                study.with(
                        study.measurements().stream()
                                .filter(one -> one.workload().equals(workload))
                                .toList());
        var notes = new ArrayList<String>();
        String leftOut = String.join(" ", LeftOutNote.of(level, this).lines());
        if (!leftOut.isEmpty()) notes.add(leftOut.endsWith(".") ? leftOut : leftOut + ".");
        notes.add(texts.text(frontNoteKey()));
        new ConditionsWords(texts.language()).measuredOn(study).ifPresent(notes::add);
        return String.join(" ", notes);
    }

    private String frontNoteKey() {
        if (costKey.equals(TIMED)) return "front.note";
        return costKey.equals(RATIO) ? "front.note.brief" : "front.note.counted";
    }

    /**
     * @param of what grows: COST or ERROR
     */
    public String growthTitle(Study study, String of) {
        return texts.text("growth.title." + of, called.topic(study.topic()));
    }

    /** How the chart of growth is read, and which methods have no place on its axis. */
    public String growthNote(Study study, String of) {
        var notes = new ArrayList<String>();
        if (of.equals("ERROR") && study.measurements().stream().anyMatch(StudyWords::hasNoNumber))
            notes.add(texts.text("growth.notRight", withoutNumber(study)));
        if (isSized(study)) notes.add(texts.text("growth.note"));
        notes.add(texts.text("growth.note." + of));
        return String.join(" ", notes);
    }

    /** Whether the size of a study's inputs says how much there is to do. */
    public static boolean isSized(Study study) {
        return Topics.named(study.topic()).sized();
    }

    /** The reason why a chart of growth has nothing to draw. */
    public String nothingGrows(Study study, String of) {
        boolean exact =
                study.measurements().stream()
                        .filter(one -> one.cost().timed())
                        .allMatch(one -> one.kind() == Verdict.Kind.EXACT);
        return texts.text(exact && of.equals("ERROR") ? "growth.allExact" : "growth.nothing");
    }

    /** Whether a result is not right though no item is misplaced, so that no number tells how. */
    private static boolean hasNoNumber(Measurement one) {
        return one.cost().timed() && Double.isInfinite(ParetoFront.error(one));
    }

    /**
     * Names the methods of the topic that a measured study has nothing of, as where it is older
     * than they are; empty where it has all.
     */
    String notMeasuredNote(Study study) {
        if (study.circumstances().isEmpty()) return "";
        Set<String> measured =
                study.measurements().stream().map(Measurement::method).collect(Collectors.toSet());
        String missing =
                Topics.named(study.topic()).methods().stream()
                        .map(Method::name)
                        .filter(name -> !measured.contains(name))
                        .map(this::called)
                        .collect(Collectors.joining(", "));
        return missing.isEmpty() ? "" : texts.text("chart.notMeasured", missing);
    }

    /** Tells which results stand in the row above all numbers, and why; empty for none. */
    String notRightNote(Study study) {
        String said = withoutNumber(study);
        return said.isEmpty() ? "" : texts.text("front.notRight.note", said);
    }

    private String withoutNumber(Study study) {
        var said = new LinkedHashMap<String, String>();
        for (Measurement one : study.measurements())
            if (hasNoNumber(one))
                said.putIfAbsent(
                        called(one.method()),
                        one.detail().isEmpty()
                                ? ""
                                : " ("
                                        + VerdictDetail.translated(texts.language(), one.detail())
                                        + ")");
        return said.entrySet().stream()
                .map(one -> one.getKey() + one.getValue())
                .collect(Collectors.joining("; "));
    }

    /** The sign for results that are not right, though no number tells by how much. */
    public String notRightShort() {
        return texts.text("front.notRight");
    }

    public String byInputTitle(Study study) {
        return texts.text("input.title", called.topic(study.topic()));
    }

    /** The method that is best in a range of sizes, or that it is open which of several is. */
    public String best(Regime regime) {
        List<String> methods = regime.methods().stream().map(this::called).toList();
        if (!regime.isOpen()) return methods.get(0);
        return texts.text(
                "regime.open",
                methods.size() > MOST_NAMED
                        ? texts.text("regime.oneOf", methods.size())
                        : String.join(texts.text("regime.or"), methods));
    }

    /** The method that is best in each range of sizes, and how the chart is read. */
    public String byInputNote(Study study, List<Regime> regimes) {
        var said = new ArrayList<String>();
        for (int i = 0; i < regimes.size(); i++) {
            Regime one = regimes.get(i);
            boolean last = i + 1 == regimes.size();
            String key =
                    last ? regimes.size() == 1 ? "regime.all" : "regime.beyond" : "regime.upTo";
            said.add(texts.text(key, best(one), LogTicks.size(one.to())));
        }
        String best = said.isEmpty() ? "" : texts.text("regimes", String.join(", ", said)) + " ";
        return best + texts.text("input.note");
    }

    /** The sign for methods that refuse, crash or come to no end. */
    public String noAnswerShort() {
        return texts.text("input.noAnswer");
    }

    public String sizeAxis(Study study) {
        return texts.textOr("growth.size." + study.topic(), texts.text("growth.size"));
    }

    public String costPerInput(Study study) {
        return texts.text(costKey.equals(TIMED) ? "growth.nanos" : "growth.operations");
    }

    /** A power of the size n. */
    public String power(double exponent, double margin) {
        return texts.text("growth.power", hundredths(exponent), hundredths(margin));
    }

    /** Two places behind the point, never a zero below zero. */
    private String hundredths(double value) {
        double rounded = Math.rint(100 * value) / 100 + 0.0;
        return String.format(locale(), "%.2f", rounded).replace('-', '−');
    }

    /** The sign for an error of zero. */
    public String exact() {
        return texts.text("chart.exact");
    }

    /**
     * How far a measurement is.
     *
     * @param last what was finished last, "" before the first
     */
    public String progress(StudyWork work, String last) {
        return last.isEmpty()
                ? texts.text("progress.begun", work.done(), work.of())
                : texts.text("progress.at", work.done(), work.of(), last);
    }

    String notTimed() {
        return texts.text("chart.notTimed");
    }

    /** The things that a workload of the topic draws, cuts or counts. */
    public String workload(String topic, String name) {
        return workloads.workload(topic, name);
    }

    /** The size beside a point of the chart, with what it counts. */
    public String size(Study study, Measurement point) {
        return workloads.size(study.topic(), point.workload(), point.size());
    }

    /**
     * @param kind refused, endless or crashed
     * @param points at whose sizes a method ended so
     */
    String reason(Study study, Verdict.Kind kind, List<Measurement> points) {
        String listed =
                points.stream().map(point -> size(study, point)).collect(Collectors.joining(", "));
        return texts.text("chart." + kind.code(), listed);
    }
}
