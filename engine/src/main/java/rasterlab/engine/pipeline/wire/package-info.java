/**
 * Faces drawn by their edges, with the hidden parts left out, dashed or shown.
 *
 * <p>A method of visibility first paints the faces' numbers, so that it decides what is hidden.
 * Edges run in eye space (x right, y up, z forward) and are walked in pixels. Start with {@link
 * rasterlab.engine.pipeline.wire.WirePicture}.
 */
package rasterlab.engine.pipeline.wire;
