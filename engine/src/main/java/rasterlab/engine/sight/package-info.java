/**
 * Tells by proof what of a scene hides what: which faces need no look, which order is right, how
 * many bits a depth needs.
 *
 * <p>Space: the world for what holds from everywhere, eye space for what holds from one place.
 * Start with {@link rasterlab.engine.sight.SightFacts}.
 */
package rasterlab.engine.sight;
