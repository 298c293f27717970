package rasterlab.engine.pipeline;

/**
 * What {@code auto} stood for.
 *
 * @param chosen a name of the same kind
 * @param reason why, in a few words
 */
public record Choice(String chosen, String reason) {}
