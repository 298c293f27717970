package rasterlab.app.cli.exercise;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import rasterlab.app.cli.console.PrettyJson;
import rasterlab.exercises.proving.Kill;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.proving.RightMethod;
import rasterlab.exercises.proving.SourcePoints;
import rasterlab.exercises.score.Phrase;

/** Proofs as one JSON object. */
final class ProofJson {
    private final JsonGenerator out;
    private final String language;

    private ProofJson(JsonGenerator out, String language) {
        this.out = out;
        this.language = language;
    }

    /**
     * @param language of the faults
     */
    static void write(List<Proof> proofs, OutputStream stream, String language) throws IOException {
        JsonGenerator out = PrettyJson.to(stream);
        out.writeStartObject();
        out.writeBooleanField("proved", proofs.stream().allMatch(one -> one.faults().isEmpty()));
        out.writeArrayFieldStart("exercises");
        for (Proof one : proofs) new ProofJson(out, language).write(one);
        out.writeEndArray();
        out.writeEndObject();
        out.writeRaw('\n');
        out.close();
    }

    private void write(Proof proof) throws IOException {
        out.writeStartObject();
        out.writeStringField("id", proof.exercise().id());
        out.writeBooleanField("proved", proof.faults().isEmpty());
        out.writeNumberField("seed", proof.seed());
        out.writeArrayFieldStart("right");
        for (RightMethod one : proof.right()) write(one);
        out.writeEndArray();
        out.writeArrayFieldStart("mistakes");
        for (Kill one : proof.kills()) write(one);
        out.writeEndArray();
        if (proof.starter().isPresent()) write("starter", proof.starter().get());
        if (proof.model().isPresent()) write("model", proof.model().get());
        out.writeArrayFieldStart("faults");
        for (Phrase one : proof.faults()) out.writeString(one.in(language));
        out.writeEndArray();
        out.writeEndObject();
    }

    private void write(RightMethod one) throws IOException {
        out.writeStartObject();
        out.writeStringField("method", one.name());
        out.writeBooleanField("promised", one.promised());
        out.writeNumberField("accuracy", one.accuracy());
        out.writeNumberField("stability", one.stability());
        write("loses", one.failed());
        write("refuses", one.refused());
        out.writeEndObject();
    }

    private void write(Kill one) throws IOException {
        out.writeStartObject();
        out.writeStringField("name", one.mistake());
        out.writeStringField("kind", one.mutant() ? "mutant" : "method");
        out.writeBooleanField("asked", one.asked());
        write("rejectedBy", one.cases());
        write("namedBy", one.naming());
        write("breaks", one.properties());
        out.writeEndObject();
    }

    private void write(String field, List<String> names) throws IOException {
        out.writeArrayFieldStart(field);
        for (String one : names) out.writeString(one);
        out.writeEndArray();
    }

    private void write(String field, SourcePoints points) throws IOException {
        out.writeObjectFieldStart(field);
        out.writeStringField("verdict", points.verdict().published().code());
        out.writeNumberField("accuracy", points.points().accuracy());
        out.writeNumberField("stability", points.points().stability());
        if (points.timed()) out.writeNumberField("speed", points.points().speed());
        else out.writeNullField("speed");
        out.writeEndObject();
    }
}
