package rasterlab.app.canvas.lab;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Format;

/**
 * An input of a topic as the commands of the labs write it: JSON with a space behind each comma and
 * colon, numbers with all their digits, but whole ones without ".0".
 */
public final class CommandInput implements ValueSink {
    private static final Pattern RUN =
            Pattern.compile("echo '([^'\\n]*)' \\| \\./lab run ([a-z-]+) [a-z0-9-]+");

    private final StringBuilder json = new StringBuilder();

    /** Whether the next value is the first of its array or object, or stands behind its name. */
    private boolean first = true;

    /** Whether a zero below zero has its sign. */
    private final boolean signed;

    private CommandInput(boolean signed) {
        this.signed = signed;
    }

    /**
     * The input as one JSON object, whose zeros have no sign.
     *
     * @throws IllegalArgumentException if it cannot be told outside
     */
    public static <I> String of(Format<?, I, ?> format, I input) {
        return of(out -> format.writeInput(input, out));
    }

    /** The input in a lab's command that runs a method of that topic; empty in any other. */
    public static Optional<String> in(String topic, String command) {
        Matcher parts = RUN.matcher(command);
        return parts.matches() && parts.group(2).equals(topic)
                ? Optional.of(parts.group(1))
                : Optional.empty();
    }

    /** Writes those fields as one JSON object, whose zeros have no sign. */
    public static String of(Written fields) {
        return new CommandInput(false).object(fields);
    }

    /**
     * Writes an input as {@link #of} does, for a topic whose answers depend on the signs of zeros.
     */
    public static <I> String signed(Format<?, I, ?> format, I input) {
        return signed(out -> format.writeInput(input, out));
    }

    /**
     * Writes fields as {@link #of} does, for a topic whose answers depend on the signs of zeros.
     */
    public static String signed(Written fields) {
        return new CommandInput(true).object(fields);
    }

    private String object(Written fields) {
        startObject();
        try {
            fields.write(this);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        endObject();
        return json.toString();
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
        String digits = Double.toString(signed ? value : value + 0.0);
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
