package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.engine.raster.PixelRecording;

/** Pixels as JSON. */
final class PixelJson {
    private PixelJson() {}

    /** Writes the field {@code pixels}: [x, y] for each. */
    static void write(JsonGenerator json, PixelRecording pixels) throws IOException {
        json.writeArrayFieldStart("pixels");
        for (int i = 0; i < pixels.size(); i++) {
            json.writeStartArray();
            json.writeNumber(pixels.x(i));
            json.writeNumber(pixels.y(i));
            json.writeEndArray();
        }
        json.writeEndArray();
    }
}
