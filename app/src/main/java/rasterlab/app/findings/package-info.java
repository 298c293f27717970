/**
 * Pages of what studies found: one for each topic with its charts, sentences that are computed from
 * the numbers, its table of hazards and the commands that repeat each figure; a page of contents,
 * and one of all fronts at a glance. Start with {@link rasterlab.app.findings.Findings}.
 */
package rasterlab.app.findings;
