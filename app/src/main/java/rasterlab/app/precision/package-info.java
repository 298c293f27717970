/**
 * The precision of depth buffers, as a chart: the smallest distance that each format tells apart
 * over far/near, measured and predicted.
 *
 * <p>Distances are shares of the depth they are measured at. Start with {@link
 * rasterlab.app.precision.DepthPrecisionChart}.
 */
package rasterlab.app.precision;
