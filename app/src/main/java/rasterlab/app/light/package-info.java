/**
 * Light as charts: brightness across a faceted sphere by each shading.
 *
 * <p>Places are in degrees of longitude along the equator, 0 being nearest to the eye. Start with
 * {@link rasterlab.app.light.MachBandsChart}.
 */
package rasterlab.app.light;
