package rasterlab.app.visibility;

import java.util.Optional;
import rasterlab.engine.raster.PictureDifference;

/**
 * What the lab shows at one moment.
 *
 * @param picture the newest finished picture, maybe of an earlier choice
 * @param difference from the exact picture of the present choice; empty while it is made or when it
 *     is not asked for
 * @param medianNanos median time of the last pictures of the present method and size; 0 while there
 *     are too few
 * @param undoable whether there is something to undo
 */
public record VisibilityLabState(
        VisibilityChoice choice,
        Optional<Picture> picture,
        Optional<PictureDifference> difference,
        long medianNanos,
        boolean undoable) {}
