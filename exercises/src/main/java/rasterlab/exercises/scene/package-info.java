/**
 * Scene files: JSON that the lab and the grader exchange.
 *
 * <p>One file holds either a case, the input of one method, or a view of a scene. World space, z
 * up, angles in radians, colours as shares of red, green and blue from 0 to 1. Start with {@link
 * rasterlab.exercises.scene.SceneFile}.
 */
package rasterlab.exercises.scene;
