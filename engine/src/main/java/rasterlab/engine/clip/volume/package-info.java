/**
 * The parts of segments in the normalised view volume, |x| ≤ z, |y| ≤ z, zmin ≤ z ≤ 1.
 *
 * <p>Eye coordinates: x right, y up, z away from the eye. Start with {@link
 * rasterlab.engine.clip.volume.CohenSutherland6}.
 */
package rasterlab.engine.clip.volume;
