/**
 * The colours of faces, pixel by pixel: light, texture, depth cue, transparency.
 *
 * <p>Light is computed in the world, before any projection; pixels are whole numbers that name
 * centres. A span goes through the stages in turn: the weights of the corners, the surface's
 * colour, the texture, the depth cue, and what is behind. A method of visibility decides which
 * spans there are, so it fits every paint. Start with {@link
 * rasterlab.engine.pipeline.paint.Paints} and {@link
 * rasterlab.engine.pipeline.paint.CornerWeights}.
 */
package rasterlab.engine.pipeline.paint;
