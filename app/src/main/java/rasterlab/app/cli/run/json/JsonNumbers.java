package rasterlab.app.cli.run.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Writes doubles so that they read back exactly; what JSON has no number for is null. */
public final class JsonNumbers {
    private JsonNumbers() {}

    public static void writeField(JsonGenerator json, String name, double value)
            throws IOException {
        json.writeFieldName(name);
        write(json, value);
    }

    public static void write(JsonGenerator json, double value) throws IOException {
        if (Double.isFinite(value)) json.writeNumber(value);
        else json.writeNull();
    }

    /** Writes an array of numbers. */
    public static void write(JsonGenerator json, double[] values) throws IOException {
        json.writeStartArray();
        for (double value : values) write(json, value);
        json.writeEndArray();
    }

    /**
     * Writes an array of points, each an array of its coordinates.
     *
     * @param coordinates point after point
     */
    public static void writePoints(JsonGenerator json, double[] coordinates, int dimension)
            throws IOException {
        json.writeStartArray();
        for (int i = 0; i < coordinates.length; i += dimension) {
            json.writeStartArray();
            for (int axis = 0; axis < dimension; axis++) write(json, coordinates[i + axis]);
            json.writeEndArray();
        }
        json.writeEndArray();
    }
}
