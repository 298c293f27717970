package rasterlab.app.signmap;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import rasterlab.engine.signmap.SignMap;

/** Writes maps for programs: what was counted, and every answer beside the right one. */
public final class SignMapJson {
    private SignMapJson() {}

    /** One JSON object: {@code maps}, each with its rows from the lowest, a character a point. */
    public static String of(List<SignMap> maps) {
        var text = new StringWriter();
        try (JsonGenerator out = new JsonFactory().createGenerator(text)) {
            out.useDefaultPrettyPrinter();
            out.writeStartObject();
            out.writeArrayFieldStart("maps");
            for (SignMap map : maps) write(map, out);
            out.writeEndArray();
            out.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.append('\n').toString();
    }

    private static void write(SignMap map, JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeStringField("predicate", map.subject());
        out.writeStringField("method", map.method());
        out.writeStringField("numbers", map.spacing().code());
        out.writeArrayFieldStart("from");
        out.writeNumber(map.x(0));
        out.writeNumber(map.y(0));
        out.writeEndArray();
        out.writeNumberField("size", map.size());
        out.writeNumberField("points", map.points());
        out.writeNumberField("wrong", map.extra() + map.missing());
        out.writeNumberField("more", map.extra());
        out.writeNumberField("less", map.missing());
        out.writeNumberField("unanswered", map.unanswered());
        out.writeNumberField("share", map.share());
        writeRows("answers", map.size(), map::answer, out);
        writeRows("exact", map.size(), map::exact, out);
        out.writeEndObject();
    }

    /** The words about a point. */
    @FunctionalInterface
    private interface SignReader {
        int at(int column, int row);
    }

    private static void writeRows(String name, int size, SignReader said, JsonGenerator out)
            throws IOException {
        out.writeArrayFieldStart(name);
        for (int row = 0; row < size; row++) {
            var line = new StringBuilder(size);
            for (int column = 0; column < size; column++)
                line.append("-0+?".charAt(1 + said.at(column, row)));
            out.writeString(line.toString());
        }
        out.writeEndArray();
    }
}
