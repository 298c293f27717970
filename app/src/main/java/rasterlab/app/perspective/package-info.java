/**
 * The amount of perspective γ as a chart: how much larger the nearer of two equal depths appears.
 *
 * <p>Distances are in units of the depth. Start with {@link
 * rasterlab.app.perspective.PerspectiveChart}.
 */
package rasterlab.app.perspective;
