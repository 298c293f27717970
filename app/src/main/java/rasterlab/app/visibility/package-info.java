/**
 * The lab of hidden surfaces: a scene turned about, drawn by one visibility method, beside the
 * exact picture.
 *
 * <p>Angles are radians, pictures are in device pixels. {@link
 * rasterlab.app.visibility.VisibilityLabModel} holds what is shown and knows no Swing; {@link
 * rasterlab.app.visibility.VisibilityPanel} shows it. {@link rasterlab.app.visibility.GrowthChart}
 * draws how the methods' work grows.
 */
package rasterlab.app.visibility;
