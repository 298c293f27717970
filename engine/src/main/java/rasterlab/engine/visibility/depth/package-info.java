/**
 * Topic {@code depth-buffer}: what a depth buffer's number format can tell apart, between a near
 * and a far plane and along a scan line.
 *
 * <p>z is the distance from the eye along the line of sight, nearness is 1/z, window depth runs
 * from 0 on the near plane to 1 on the far plane. Start with {@link
 * rasterlab.engine.visibility.depth.FixedDepth}; {@link
 * rasterlab.engine.visibility.depth.DepthBufferTopic} lists everything.
 */
package rasterlab.engine.visibility.depth;
