package rasterlab.app.light;

import java.util.Optional;
import rasterlab.app.canvas.method.HazardNote;

/**
 * The state that the lab shows at one moment.
 *
 * @param colors whether colour models are shown instead of light
 * @param drawn the newest pictures, maybe of an earlier choice
 * @param color the colour in all models
 * @param problem why a file was not opened, or what of it is not shown; "" if nothing or something
 *     else was chosen since
 * @param note in what the picture is other than the hazard that it was opened for
 */
public record LightLabState(
        LightChoice choice,
        boolean colors,
        Optional<LightFrame.DrawnFrame> drawn,
        ColorChoice color,
        String problem,
        Optional<HazardNote> note) {}
