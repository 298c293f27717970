package rasterlab.engine.pipeline.fast;

/** Gives vertices their colours: light by Gouraud's way plugs in here. */
@FunctionalInterface
public interface VertexColors {
    /**
     * Writes {@code red, green, blue, alpha} of the block's vertices, 0 to 1; what is beyond is
     * cut. Called by several threads at once, each with a block of its own.
     */
    void color(VertexBlock block);

    /** The mesh's own colours, opaque white where it has none. */
    static VertexColors own() {
        return block -> {};
    }
}
