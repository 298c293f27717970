/**
 * Plans of many scenes, cameras and tolerances, each held against the full pipeline and against all
 * combinations.
 *
 * <p>Start with {@link rasterlab.tests.bench.plan.PlanBench}.
 */
package rasterlab.tests.bench.plan;
