/**
 * Draws what a request asks for: scene → view → light → visibility → raster, each stage chosen by
 * name, or by {@code auto} as the cheapest that is right.
 *
 * <p>Depths are world units along the line of sight, sizes are pixels. Below: {@code paint} colours
 * faces for any visibility method, {@code wire} draws their edges, {@code plain} is the pipeline on
 * one page, {@code fast} the same for speed with the pixels' colours in {@code surface}, {@code
 * direct} draws whole scenes by it. Start with {@link rasterlab.engine.pipeline.Renderer}.
 */
package rasterlab.engine.pipeline;
