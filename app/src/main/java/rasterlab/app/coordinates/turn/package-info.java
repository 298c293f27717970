/**
 * The lab of the topic {@code rotate}: a point turned about the origin again and again, and how far
 * each method drifts from the exact place.
 *
 * <p>Plane coordinates grow to the right and up, angles are in degrees and counter-clockwise. Start
 * with {@link rasterlab.app.coordinates.turn.TurnScene}; {@link
 * rasterlab.app.coordinates.turn.TurnLabModel} knows no Swing.
 */
package rasterlab.app.coordinates.turn;
