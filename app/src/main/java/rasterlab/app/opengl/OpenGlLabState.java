package rasterlab.app.opengl;

import java.util.List;
import java.util.Optional;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Setting;
import rasterlab.engine.raster.Raster;

/**
 * The state that the lab shows at one moment.
 *
 * @param calls of the present choice's frame; empty before there is a size
 * @param pictures the newest that are finished, maybe of an earlier choice
 * @param report what OpenGL says of itself, once a context was made
 * @param missing why there is no OpenGL, if there is none
 * @param problem with an image that the user gave, in English, with the path
 * @param touched the setting that was changed last
 */
public record OpenGlLabState(
        GlChoice choice,
        List<GlCall> calls,
        OpenGlPictures pictures,
        Optional<GlReport> report,
        Optional<String> missing,
        Optional<String> problem,
        Setting touched) {
    /**
     * Pictures of one frame.
     *
     * @param openGl empty where there is no OpenGL
     * @param difference of the two
     */
    public record OpenGlPictures(
            Optional<Raster> openGl, Optional<Raster> software, Optional<Comparison> difference) {
        static final OpenGlPictures NONE =
                new OpenGlPictures(Optional.empty(), Optional.empty(), Optional.empty());
    }
}
