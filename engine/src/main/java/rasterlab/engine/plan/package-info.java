/**
 * The least model that is enough: what of a scene must be drawn, and how, so that the picture is
 * within a tolerance of the full pipeline's.
 *
 * <p>A tolerance is in pixels and in levels of 0 to 255. Bounds come first, measuring checks them.
 * Start with {@link rasterlab.engine.plan.Planner}.
 */
package rasterlab.engine.plan;
