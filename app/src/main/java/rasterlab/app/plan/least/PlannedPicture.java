package rasterlab.app.plan.least;

import rasterlab.engine.plan.Plan;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.SphericalView;

/**
 * A picture that was drawn by a plan.
 *
 * @param plan by which; one that leaves nothing out where another one's would have been a jump
 * @param camera from which
 * @param raster the picture
 * @param pictures that the plan has drawn in a row, at least 1: this one is the last
 */
public record PlannedPicture(Plan plan, SphericalView camera, Raster raster, int pictures) {
    public PlannedPicture {
        Bounds.requireAtLeast("pictures", pictures, 1);
    }
}
