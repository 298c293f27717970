/**
 * What is told of a picture that was drawn and of one that was planned: choices with their reasons,
 * counted work, measured time, errors.
 *
 * <p>Start with {@link rasterlab.app.plan.PlanReport}.
 */
package rasterlab.app.plan;
