package rasterlab.engine.sight.cost;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The work of one picture, counted stage by stage.
 *
 * @param vertices brought into the eye's space
 * @param clipped faces cut by the near, the far or a clip plane
 * @param faces set up for drawing
 * @param lights times the light formula is worked out for a face or a corner
 * @param fragments pixels covered by faces, each as often as it is: one depth test each where
 *     depths decide
 * @param pixelLights times the light formula is worked out for a pixel
 * @param texels texture elements read
 * @param pixels of the picture, cleared first
 * @param pairs two faces compared with each other
 */
public record PictureWork(
        long vertices,
        long clipped,
        long faces,
        long lights,
        long fragments,
        long pixelLights,
        long texels,
        long pixels,
        long pairs) {

    /** Stage to number, in the order in which a picture is made. */
    public Map<String, Long> stages() {
        var stages = new LinkedHashMap<String, Long>();
        stages.put("vertices", vertices);
        stages.put("clipped", clipped);
        stages.put("faces", faces);
        stages.put("pairs", pairs);
        stages.put("lights", lights);
        stages.put("fragments", fragments);
        stages.put("pixel-lights", pixelLights);
        stages.put("texels", texels);
        stages.put("pixels", pixels);
        return stages;
    }
}
