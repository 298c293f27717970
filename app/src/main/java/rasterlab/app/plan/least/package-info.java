/**
 * The least picture within a tolerance, in a lab: drawn, kept while the camera moves, measured.
 *
 * <p>Start with {@link rasterlab.app.plan.least.PlanDrawing}; {@link
 * rasterlab.app.plan.least.LeastRows} is the only part that is seen.
 */
package rasterlab.app.plan.least;
