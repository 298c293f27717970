package rasterlab.engine.pipeline.paint;

/** How the backs of faces are lit. */
public enum Sides {
    /** Backs are lit as the scene's light model says. */
    SCENE,
    /** Backs are lit as their fronts are, with the same normal. */
    ONE,
    /** Back faces are lit by their own material, with the normal turned round. */
    TWO
}
