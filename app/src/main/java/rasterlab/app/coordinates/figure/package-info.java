/**
 * The parts that the labs of coordinates share: matrices by name in the textbook's layout, wires,
 * figures of the plane and of space, choices that can be undone.
 *
 * <p>{@code space} coordinates are three numbers in a frame that its user names; {@code plane}
 * coordinates are those of the stage. Points are rows and matrices stand right of them. Start with
 * {@link rasterlab.app.coordinates.figure.Chains}.
 */
package rasterlab.app.coordinates.figure;
