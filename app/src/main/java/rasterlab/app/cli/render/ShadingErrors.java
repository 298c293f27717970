package rasterlab.app.cli.render;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;

/**
 * How far the cheaper shadings' pictures are from Phong's.
 *
 * @param found by the name of the shading
 */
record ShadingErrors(Map<String, PictureDifference> found) {
    private static final List<ShadingMethod> CHEAPER =
            List.of(ShadingMethod.FLAT, ShadingMethod.GOURAUD);

    static ShadingErrors of(RenderRequest request, BooleanSupplier cancelled) {
        var renderer = new Renderer();
        Raster exact = renderer.render(request.withShading(ShadingMethod.PHONG), cancelled);
        Map<String, PictureDifference> found = new LinkedHashMap<>();
        for (ShadingMethod shading : CHEAPER)
            found.put(
                    shading.code(),
                    PictureDifference.of(
                            exact, renderer.render(request.withShading(shading), cancelled)));
        return new ShadingErrors(found);
    }

    void write(JsonGenerator json) throws IOException {
        json.writeObjectFieldStart("errorsAgainstPhong");
        for (var entry : found.entrySet()) {
            json.writeObjectFieldStart(entry.getKey());
            RenderReport.writeCounts(json, entry.getValue());
            json.writeEndObject();
        }
        json.writeEndObject();
    }
}
