/**
 * From a request to a picture: scene → view → light → visibility → raster, each stage chosen by
 * name.
 *
 * <p>Start with {@link rasterlab.engine.pipeline.Renderer}.
 */
package rasterlab.engine.pipeline;
