package rasterlab.app.study;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/** A study as JSON, with the machine it was measured on. */
final class StudyJson {
    private final JsonGenerator json;

    private StudyJson(JsonGenerator json) {
        this.json = json;
    }

    static byte[] of(Study study, Machine machine) {
        var bytes = new ByteArrayOutputStream();
        try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
            json.useDefaultPrettyPrinter();
            new StudyJson(json).write(study, machine);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private void write(Study study, Machine machine) throws IOException {
        json.writeStartObject();
        json.writeStringField("topic", study.topic());
        json.writeStringField("item", study.item());
        json.writeStringField("errorUnit", study.errorUnit());
        write(machine);
        json.writeArrayFieldStart("measurements");
        for (Measurement measured : study.measurements()) write(measured);
        json.writeEndArray();
        json.writeEndObject();
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

    private void write(Measurement measured) throws IOException {
        json.writeStartObject();
        json.writeStringField("method", measured.method());
        json.writeStringField("workload", measured.workload());
        json.writeNumberField("size", measured.size());
        write(measured.cost());
        write(measured.error());
        json.writeStringField("verdict", measured.kind().code());
        json.writeStringField("detail", measured.detail());
        json.writeEndObject();
    }

    private void write(Cost cost) throws IOException {
        json.writeObjectFieldStart("nanosPerItem");
        json.writeNumberField("median", cost.medianNanos());
        json.writeNumberField("low", cost.lowNanos());
        json.writeNumberField("high", cost.highNanos());
        json.writeEndObject();
        json.writeObjectFieldStart("counts");
        for (Map.Entry<String, Long> count : cost.counts().entrySet())
            json.writeNumberField(count.getKey(), count.getValue());
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
