/**
 * The lab of light and colour: a body lit by lamps in three shadings, and a colour in all models.
 *
 * <p>Lamps stand in world units, pictures are in device pixels, places of the profile are shares of
 * a picture. {@link rasterlab.app.light.LightLabModel} holds what is shown and knows no Swing;
 * {@link rasterlab.app.light.panel.LightPanel} shows it. {@link rasterlab.app.light.MachBandsChart}
 * draws the brightness across a faceted sphere for the shell.
 */
package rasterlab.app.light;
