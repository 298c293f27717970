package rasterlab.app.study;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.front.SizesChart;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Ranking;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.measuring.Machine;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.PaceComparison;
import rasterlab.engine.study.measuring.PowerFit;

/** A study as JSON, with the machine that it was measured on, how, and every round. */
final class StudyJson {
    /** Where a study was stopped that is not whole. */
    private static final String BEFORE = "before the first round";

    private static final String IN_ROUNDS = "between rounds";

    private final JsonGenerator json;
    private final boolean brief;

    private StudyJson(JsonGenerator json, boolean brief) {
        this.json = json;
        this.brief = brief;
    }

    static byte[] of(Study study) {
        return of(study, false);
    }

    /**
     * The study without what follows from its rounds, a line for each measurement: a reader of a
     * study asks for no more.
     */
    static byte[] brief(Study study) {
        return of(study, true);
    }

    private static byte[] of(Study study, boolean brief) {
        var bytes = new ByteArrayOutputStream();
        try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
            if (!brief) json.useDefaultPrettyPrinter();
            new StudyJson(json, brief).write(study);
            if (brief) json.writeRaw('\n');
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private void write(Study study) throws IOException {
        json.writeStartObject();
        json.writeStringField("topic", study.topic());
        json.writeStringField("item", study.item());
        json.writeStringField("errorUnit", study.errorUnit());
        if (study.circumstances().isPresent()) write(study, study.circumstances().get());
        json.writeArrayFieldStart("measurements");
        for (Measurement measured : study.measurements()) {
            if (brief) json.writeRaw('\n');
            write(measured, study.noise(measured.workload()));
        }
        json.writeEndArray();
        if (!brief) writeConclusions(study);
        json.writeEndObject();
    }

    private void writeConclusions(Study study) throws IOException {
        json.writeArrayFieldStart("comparisons");
        for (Ranking ranking : Ranking.all(study)) write(ranking);
        json.writeEndArray();
        json.writeArrayFieldStart("growth");
        for (SizesChart.Of of : SizesChart.Of.values()) writeGrowth(study, of);
        json.writeEndArray();
    }

    /** Writes the fitted power of the size for each method: factor · size ^ (exponent ± margin). */
    private void writeGrowth(Study study, SizesChart.Of of) throws IOException {
        var words = new StudyWords(Language.ENGLISH);
        var fits = new SizesChart(study, of, words, ChartLook.PAPER).fits();
        for (Map.Entry<String, PowerFit> fit : fits.entrySet()) {
            json.writeStartObject();
            json.writeStringField("of", of.name().toLowerCase(Locale.ROOT));
            json.writeStringField("method", fit.getKey());
            json.writeNumberField("exponent", fit.getValue().exponent());
            json.writeNumberField("margin", fit.getValue().margin());
            json.writeNumberField("factor", fit.getValue().factor());
            json.writeEndObject();
        }
    }

    private void write(Study study, StudyConditions how) throws IOException {
        write(how.machine());
        StudySettings settings = how.settings();
        json.writeStringField("date", how.begun().toString());
        json.writeBooleanField("whole", how.whole());
        if (!how.whole()) json.writeStringField("stopped", study.isTimed() ? IN_ROUNDS : BEFORE);
        json.writeNumberField("seed", settings.seed());
        json.writeObjectFieldStart("settings");
        json.writeNumberField("warmUpMillis", millis(settings.warmUp()));
        json.writeNumberField("roundMillis", millis(settings.round()));
        json.writeNumberField("rounds", settings.rounds());
        json.writeNumberField("wallLimitMillis", millis(settings.wallLimit()));
        json.writeNumberField("budgetMillis", millis(settings.budget()));
        json.writeEndObject();
        json.writeObjectFieldStart("load");
        json.writeNumberField("before", how.loadBefore());
        json.writeNumberField("after", how.loadAfter());
        json.writeEndObject();
        json.writeArrayFieldStart("noise");
        for (Map.Entry<String, List<Double>> fixed : new TreeMap<>(how.fixed()).entrySet()) {
            json.writeStartObject();
            json.writeStringField("workload", fixed.getKey());
            json.writeNumberField("factor", study.noise(fixed.getKey()));
            write("rounds", fixed.getValue());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static double millis(Duration time) {
        return time.toNanos() / 1e6;
    }

    private void write(String name, List<Double> numbers) throws IOException {
        json.writeArrayFieldStart(name);
        for (double number : numbers) json.writeNumber(number);
        json.writeEndArray();
    }

    /** Writes each pair once, the quicker median first. */
    private void write(Ranking ranking) throws IOException {
        for (int slow = 1; slow < ranking.places().size(); slow++)
            for (int fast = 0; fast < slow; fast++) {
                PaceComparison pair = ranking.compared(fast, slow);
                json.writeStartObject();
                json.writeStringField("workload", ranking.workload());
                json.writeStringField("method", ranking.places().get(fast).method());
                json.writeStringField("other", ranking.places().get(slow).method());
                json.writeStringField("order", pair.order().name().toLowerCase(Locale.ROOT));
                json.writeNumberField("ratio", pair.ratio());
                json.writeNumberField("low", pair.low());
                json.writeNumberField("high", pair.high());
                if (pair.more().isPresent())
                    json.writeNumberField("moreRounds", pair.more().getAsInt());
                json.writeEndObject();
            }
    }

    private void write(Machine machine) throws IOException {
        json.writeObjectFieldStart("machine");
        json.writeStringField("system", machine.system());
        json.writeStringField("processor", machine.processor());
        json.writeNumberField("cores", machine.cores());
        json.writeNumberField("heapBytes", machine.heapBytes());
        json.writeStringField("java", machine.java());
        json.writeEndObject();
    }

    private void write(Measurement measured, double noise) throws IOException {
        json.writeStartObject();
        json.writeStringField("method", measured.method());
        json.writeStringField("workload", measured.workload());
        json.writeNumberField("size", measured.size());
        write(measured.cost(), noise);
        write(measured.error());
        write("errors", measured.errors());
        json.writeStringField("verdict", measured.kind().code());
        json.writeStringField("detail", measured.detail());
        json.writeEndObject();
    }

    private void write(Cost cost, double noise) throws IOException {
        if (cost.timed()) writeNanos(cost, noise);
        else json.writeNullField("nanosPerItem");
        write("rounds", cost.rounds());
        json.writeObjectFieldStart("counts");
        for (Map.Entry<String, Long> count : cost.counts().entrySet())
            json.writeNumberField(count.getKey(), count.getValue());
        json.writeEndObject();
    }

    private void writeNanos(Cost cost, double noise) throws IOException {
        json.writeObjectFieldStart("nanosPerItem");
        json.writeNumberField("median", cost.medianNanos());
        json.writeNumberField("low", cost.lowNanos());
        json.writeNumberField("high", cost.highNanos());
        if (!brief) {
            MedianInterval interval = cost.interval(noise);
            write("interval", List.of(interval.low(), interval.high()));
        }
        json.writeEndObject();
    }

    private void write(Deviation error) throws IOException {
        json.writeObjectFieldStart("error");
        json.writeNumberField("worst", error.worst());
        json.writeNumberField("missing", error.missing());
        json.writeNumberField("extra", error.extra());
        json.writeNumberField("of", error.of());
        json.writeStringField("first", error.first());
        json.writeEndObject();
    }
}
