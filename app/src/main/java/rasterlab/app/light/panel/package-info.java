/**
 * The lab of light and colour as the window shows it: pictures with lamps that are dragged, the
 * colour cube, the formula in numbers. Places on the stage are in view units. The model stands in
 * the package above. Start reading at {@link LightPanel}.
 */
package rasterlab.app.light.panel;
