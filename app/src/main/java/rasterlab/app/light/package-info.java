/**
 * Light as charts: brightness across a faceted sphere by each shading.
 *
 * <p>Places are in faces along the equator, from the western rim. Start with {@link
 * rasterlab.app.light.MachBandsChart}.
 */
package rasterlab.app.light;
