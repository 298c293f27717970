package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.engine.format.ValueSink;

/** Writes values as JSON. */
public class JsonSink implements ValueSink {
    private final JsonGenerator json;

    public JsonSink(JsonGenerator json) {
        this.json = json;
    }

    @Override
    public void startObject() throws IOException {
        json.writeStartObject();
    }

    @Override
    public void endObject() throws IOException {
        json.writeEndObject();
    }

    @Override
    public void startArray() throws IOException {
        json.writeStartArray();
    }

    @Override
    public void endArray() throws IOException {
        json.writeEndArray();
    }

    @Override
    public void name(String field) throws IOException {
        json.writeFieldName(field);
    }

    @Override
    public void number(double value) throws IOException {
        if (Double.isFinite(value)) json.writeNumber(value);
        else json.writeNull();
    }

    @Override
    public void whole(long value) throws IOException {
        json.writeNumber(value);
    }

    @Override
    public void flag(boolean value) throws IOException {
        json.writeBoolean(value);
    }

    @Override
    public void text(String value) throws IOException {
        json.writeString(value);
    }

    @Override
    public void nothing() throws IOException {
        json.writeNull();
    }
}
