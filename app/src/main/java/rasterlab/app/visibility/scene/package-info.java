/**
 * The views of the lab of hidden surfaces: scenes by name, from files and from inputs of topics,
 * with camera and look. Angles are radians, lengths world units. Start reading at {@link
 * VisibilityChoice}.
 */
package rasterlab.app.visibility.scene;
