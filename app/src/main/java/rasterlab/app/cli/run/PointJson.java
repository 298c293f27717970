package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;

/** Points as JSON. */
final class PointJson {
    /** The most points of one input. */
    static final int MOST = 10_000_000;

    private PointJson() {}

    /** The field {@code points} of so many coordinates each. */
    static JsonField<double[]> points(int dimension) {
        return JsonField.required("points", json -> json.points(dimension, 0, MOST));
    }

    /** Writes the field {@code points}. */
    static void write(JsonGenerator json, double[] points, int dimension) throws IOException {
        json.writeFieldName("points");
        JsonNumbers.writePoints(json, points, dimension);
    }
}
