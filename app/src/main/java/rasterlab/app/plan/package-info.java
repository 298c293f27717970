/**
 * The words on a picture that was drawn and on one that was planned: choices with their reasons,
 * counted work, measured time, errors.
 *
 * <p>Start with {@link rasterlab.app.plan.PlanReport}.
 */
package rasterlab.app.plan;
