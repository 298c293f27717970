/**
 * Pictures by a depth buffer: for each pixel the nearest depth so far, as a number of some bits.
 *
 * <p>Spaces: pixels, and nearness, which is linear in them and grows towards the eye. Start with
 * {@link rasterlab.engine.visibility.buffer.ZBuffer}, then {@link
 * rasterlab.engine.visibility.buffer.DepthCodes} for what is stored and {@link
 * rasterlab.engine.visibility.buffer.PixelHistory} for what happened at one pixel.
 */
package rasterlab.engine.visibility.buffer;
