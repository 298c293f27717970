/**
 * The answers of the user's own program in the lab of light, one after the other beside the right
 * ones: the light of each point, or the normal of each vertex.
 *
 * <p>Points are in the world's units; colours are shares from 0 to 1. Start at {@link
 * rasterlab.app.light.step.OwnSteps}.
 */
package rasterlab.app.light.step;
