package rasterlab.app.cli;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.PictureDifference;

/**
 * What {@code ./lab render} prints.
 *
 * @param milliseconds wall time of the rendering alone
 * @param out where the picture was written; null if it was not
 * @param other what it was compared with; null if with nothing
 */
record RenderReport(
        RenderRequest request,
        double milliseconds,
        Path out,
        Path other,
        Optional<PictureDifference> difference) {

    /** Writes one JSON object and a line end. */
    void write(OutputStream stream) throws IOException {
        try (JsonGenerator json = new JsonFactory().createGenerator(stream)) {
            json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET).useDefaultPrettyPrinter();
            json.writeStartObject();
            writeRequest(json);
            json.writeNumberField("milliseconds", milliseconds);
            if (out != null) json.writeStringField("out", out.toString());
            if (difference.isPresent()) writeDifference(json, difference.get());
            json.writeEndObject();
            json.writeRaw('\n');
        }
    }

    private void writeRequest(JsonGenerator json) throws IOException {
        json.writeStringField("scene", request.scene().name());
        json.writeStringField("visibility", request.visibility());
        json.writeStringField("shading", request.shading());
        json.writeStringField("projection", request.projection());
        json.writeObjectFieldStart("camera");
        json.writeNumberField("theta", request.camera().thetaRadians());
        json.writeNumberField("phi", request.camera().phiRadians());
        json.writeNumberField("rho", request.camera().rho());
        json.writeEndObject();
        json.writeNumberField("pictureScale", request.scene().pictureScale());
        json.writeBooleanField("outline", request.outline());
        json.writeNumberField("width", request.width());
        json.writeNumberField("height", request.height());
    }

    private void writeDifference(JsonGenerator json, PictureDifference found) throws IOException {
        json.writeObjectFieldStart("diff");
        json.writeStringField("with", other.toString());
        json.writeNumberField("wrongPixels", found.wrongPixels());
        json.writeNumberField("pixels", found.pixels());
        json.writeNumberField("share", found.share());
        json.writeNumberField("largestLevelDifference", found.largestLevelDifference());
        json.writeEndObject();
    }
}
