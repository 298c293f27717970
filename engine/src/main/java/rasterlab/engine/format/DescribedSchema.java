package rasterlab.engine.format;

import java.io.IOException;

/** Passes a schema on with a description of what it is about as its first field. */
final class DescribedSchema implements ValueSink {
    private final ValueSink out;
    private final String description;
    private boolean told;

    DescribedSchema(ValueSink out, String description) {
        this.out = out;
        this.description = description;
    }

    @Override
    public void startObject() throws IOException {
        out.startObject();
        if (!told) out.text("description", description);
        told = true;
    }

    @Override
    public void endObject() throws IOException {
        out.endObject();
    }

    @Override
    public void startArray() throws IOException {
        out.startArray();
    }

    @Override
    public void endArray() throws IOException {
        out.endArray();
    }

    @Override
    public void name(String field) throws IOException {
        out.name(field);
    }

    @Override
    public void number(double value) throws IOException {
        out.number(value);
    }

    @Override
    public void whole(long value) throws IOException {
        out.whole(value);
    }

    @Override
    public void flag(boolean value) throws IOException {
        out.flag(value);
    }

    @Override
    public void text(String value) throws IOException {
        out.text(value);
    }

    @Override
    public void nothing() throws IOException {
        out.nothing();
    }
}
