package rasterlab.engine.plan;

import rasterlab.engine.pipeline.RenderRequest;

/**
 * One way to draw a picture, tried by {@link BruteForce}.
 *
 * @param name what it is made of
 * @param request draws it
 * @param error against the full pipeline
 * @param processor least processor time of several rounds, all threads together, milliseconds
 */
public record Combination(
        String name, RenderRequest request, ToleratedDifference error, double processor) {}
