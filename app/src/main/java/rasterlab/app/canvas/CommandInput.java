package rasterlab.app.canvas;

import java.io.IOException;
import java.io.UncheckedIOException;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.study.Format;

/**
 * An input of a topic as the commands of the labs write it: JSON with a space behind each comma and
 * colon, numbers with all their digits, but whole ones without ".0" and no zero with a sign.
 */
public final class CommandInput implements ValueSink {
    private final StringBuilder json = new StringBuilder();

    /** Whether the next value is the first of its array or object, or stands behind its name. */
    private boolean first = true;

    private CommandInput() {}

    /**
     * The input as one JSON object.
     *
     * @throws IllegalArgumentException if it cannot be told outside
     */
    public static <I> String of(Format<?, I, ?> format, I input) {
        var written = new CommandInput();
        written.startObject();
        try {
            format.writeInput(input, written);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        written.endObject();
        return written.json.toString();
    }

    private void add(String text) {
        if (!first) json.append(", ");
        json.append(text);
        first = false;
    }

    private void start(char bracket) {
        add("" + bracket);
        first = true;
    }

    private void end(char bracket) {
        json.append(bracket);
        first = false;
    }

    @Override
    public void startObject() {
        start('{');
    }

    @Override
    public void endObject() {
        end('}');
    }

    @Override
    public void startArray() {
        start('[');
    }

    @Override
    public void endArray() {
        end(']');
    }

    @Override
    public void name(String field) {
        add('"' + field + "\": ");
        first = true;
    }

    @Override
    public void number(double value) {
        String digits = Double.toString(value + 0.0);
        add(digits.endsWith(".0") ? digits.substring(0, digits.length() - 2) : digits);
    }

    @Override
    public void whole(long value) {
        add(Long.toString(value));
    }

    @Override
    public void flag(boolean value) {
        add(Boolean.toString(value));
    }

    @Override
    public void text(String value) {
        add('"' + value.replace("\\", "\\\\").replace("\"", "\\\"") + '"');
    }

    @Override
    public void nothing() {
        add("null");
    }
}
