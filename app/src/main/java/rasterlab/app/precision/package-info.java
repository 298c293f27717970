/**
 * What depth buffers tell apart, as a chart: the smallest distance over far/near for each format,
 * measured and predicted.
 *
 * <p>Distances are shares of the depth they are measured at. Start with {@link
 * rasterlab.app.precision.DepthPrecisionChart}.
 */
package rasterlab.app.precision;
