/**
 * The door of the engine: what there is, by name.
 *
 * <p>A package below is one topic of the course, or what topics share. Start with {@link
 * rasterlab.engine.Topics}.
 */
package rasterlab.engine;
