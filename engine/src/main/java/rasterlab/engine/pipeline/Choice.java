package rasterlab.engine.pipeline;

/**
 * The choice that {@code auto} stood for.
 *
 * @param chosen a name of the same kind
 * @param reason why, in a few words
 */
public record Choice(String chosen, String reason) {}
