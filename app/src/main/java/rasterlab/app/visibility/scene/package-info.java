/**
 * What the lab of hidden surfaces looks at, from where and how: scenes by name, from files and from
 * inputs of topics. Angles are radians, lengths world units. Start reading at {@link
 * VisibilityChoice}.
 */
package rasterlab.app.visibility.scene;
