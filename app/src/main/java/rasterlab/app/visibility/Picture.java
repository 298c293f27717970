package rasterlab.app.visibility;

import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;

/**
 * A finished picture; nobody writes into it any more.
 *
 * @param nanos how long it took to make
 */
public record Picture(RenderRequest request, Raster raster, long nanos) {}
