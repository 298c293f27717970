package rasterlab.app.canvas;

/**
 * How a plane is laid on the stage.
 *
 * @param up whether y grows upward, as in mathematics; otherwise downward, as on a raster
 * @param equal whether a unit is as long in x as in y; otherwise each axis fills the stage
 */
public record PlaneAxes(boolean up, boolean equal) {
    /** Pixels: y down, squares stay squares. */
    public static final PlaneAxes RASTER = new PlaneAxes(false, true);

    /** Geometry: y up, squares stay squares. */
    public static final PlaneAxes GEOMETRY = new PlaneAxes(true, true);

    /** The graph of a function: y up, each axis with a scale of its own. */
    public static final PlaneAxes GRAPH = new PlaneAxes(true, false);
}
