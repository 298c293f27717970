package rasterlab.app.visibility;

import java.util.Optional;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;

/**
 * A finished picture; nobody writes into it any more.
 *
 * @param nanos how long it took to make
 * @param refusal what the method said instead of drawing; the picture is then empty
 */
public record Picture(RenderRequest request, Raster raster, long nanos, Optional<String> refusal) {}
