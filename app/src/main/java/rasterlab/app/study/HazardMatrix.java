package rasterlab.app.study;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.OutputStream;
import java.time.Duration;
import java.util.List;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * The verdict of every method of a topic on each of its hazards.
 *
 * @param methods in the topic's order
 * @param hazards in the topic's order
 * @param cells one for each pair
 */
public record HazardMatrix(
        String topic, List<String> methods, List<String> hazards, List<VerdictCell> cells) {
    public HazardMatrix {
        methods = List.copyOf(methods);
        hazards = List.copyOf(hazards);
        cells = List.copyOf(cells);
    }

    /**
     * Tries every method on every hazard.
     *
     * @param longest wall time that a method may take for one hazard
     */
    public static HazardMatrix judged(Topic<?, ?, ?> topic, Duration longest) {
        return of(topic, HazardTrial.table(topic, longest));
    }

    /**
     * The verdicts of a topic that are there.
     *
     * @param cells one for each pair, or the first of them
     */
    public static HazardMatrix of(Topic<?, ?, ?> topic, List<VerdictCell> cells) {
        return new HazardMatrix(
                topic.name(),
                topic.methods().stream().map(Method::name).toList(),
                topic.hazards().stream().map(Hazard::name).toList(),
                cells);
    }

    /** Whether every verdict is the recorded one. */
    public boolean asRecorded() {
        return cells.stream().allMatch(VerdictCell::asRecorded);
    }

    /** The cell of that pair. */
    public VerdictCell cell(String hazard, String method) {
        return cells.stream()
                .filter(cell -> cell.hazard().equals(hazard) && cell.method().equals(method))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(hazard + ", " + method));
    }

    /** Writes one JSON object and a line end. */
    public static void writeJson(List<HazardMatrix> matrices, OutputStream out) throws IOException {
        var json = new JsonFactory().createGenerator(out);
        json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET).useDefaultPrettyPrinter();
        json.writeStartObject();
        json.writeBooleanField("asRecorded", matrices.stream().allMatch(HazardMatrix::asRecorded));
        json.writeArrayFieldStart("verdicts");
        for (HazardMatrix matrix : matrices)
            for (VerdictCell cell : matrix.cells) writeCell(json, matrix.topic, cell);
        json.writeEndArray();
        json.writeEndObject();
        json.writeRaw('\n');
        json.close();
    }

    private static void writeCell(JsonGenerator json, String topic, VerdictCell cell)
            throws IOException {
        json.writeStartObject();
        json.writeStringField("topic", topic);
        json.writeStringField("hazard", cell.hazard());
        json.writeStringField("method", cell.method());
        json.writeStringField("verdict", cell.verdict().kind().code());
        json.writeStringField("recorded", cell.recorded().code());
        json.writeNumberField("worst", cell.verdict().deviation().worst());
        json.writeNumberField("missing", cell.verdict().deviation().missing());
        json.writeNumberField("extra", cell.verdict().deviation().extra());
        json.writeStringField("detail", cell.verdict().detail());
        json.writeEndObject();
    }
}
