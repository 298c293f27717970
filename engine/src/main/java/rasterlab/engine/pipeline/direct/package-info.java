/**
 * Scenes by the triangle pipeline: triangles with their surfaces, drawn on all cores.
 *
 * <p>Space: the world is the pipeline's eye space, since light is reckoned in the world; one matrix
 * leads from there to clip space. Start with {@link
 * rasterlab.engine.pipeline.direct.DirectPicture}.
 */
package rasterlab.engine.pipeline.direct;
