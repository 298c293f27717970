/**
 * Topic {@code rotate}: turning points of the plane about the origin, once or ten million times.
 *
 * <p>x to the right, y up, angles in degrees, counter-clockwise. Start with {@link
 * rasterlab.engine.transform.rotate.DirectRotation}; {@link
 * rasterlab.engine.transform.rotate.RotateTopic} lists everything.
 */
package rasterlab.engine.transform.rotate;
