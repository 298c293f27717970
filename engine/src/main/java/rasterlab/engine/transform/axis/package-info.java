/**
 * Topic {@code rotate-axis}: turning points about any line of space.
 *
 * <p>Right-handed space, points as rows, angles in degrees, counter-clockwise seen from where the
 * direction (l, m, n) points to. Start with {@link rasterlab.engine.transform.axis.SevenSteps};
 * {@link rasterlab.engine.transform.axis.AxisTopic} lists everything.
 */
package rasterlab.engine.transform.axis;
